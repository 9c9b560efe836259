#include "StudyText.h"

#include <algorithm>
#include <cmath>

#include "CaseMeasures.h"
#include "FaceScheme.h"
#include "GridResolution.h"
#include "JsonText.h"
#include "NumberRange.h"
#include "NumberText.h"
#include "RowLayout.h"

namespace mien {

namespace {

constexpr const char* all = "all";
constexpr int largestHarmonics = 10'000;  // far beyond K / 2 of any face
constexpr int largestSide = 4096;         // as a sweep's

const Json& listOf(const Json& value) {
  if (!value.is_array()) refuse("a list [...] is needed where there is " + std::string(value.type_name()));
  if (value.empty()) refuse("the list is empty; name at least one, or leave the member out");
  if (value.size() > Study::longestList)
    refuse("the list has " + std::to_string(value.size()) + " entries, more than " +
           std::to_string(Study::longestList));
  return value;
}

std::string textOf(const Json& value) {
  if (!value.is_string()) refuse("a text is needed where there is " + std::string(value.type_name()));
  const std::string text = value;
  const auto isControl = [](unsigned char c) { return c < 32 || c == 127; };
  if (text.empty() || text.size() > 4096 || std::any_of(text.begin(), text.end(), isControl))
    refuse(inQuotes(text) + " is empty, longer than 4,096 bytes or has control characters");
  return text;
}

/// A case that stands there twice would be computed twice.
template <class Value>
void refuseTwice(const std::vector<Value>& values) {
  std::vector<Value> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) refuse("something stands there twice");
}

std::vector<std::string> textsOf(const Json& value) {
  std::vector<std::string> texts;
  for (const Json& one : listOf(value)) texts.push_back(textOf(one));
  refuseTwice(texts);
  return texts;
}

double numberOf(const Json& value) {
  if (!value.is_number()) refuse("a number is needed where there is " + std::string(value.type_name()));
  const auto number = value.get<double>();
  if (!std::isfinite(number)) refuse("a number is too large");
  return number;
}

/// A number, a list of them, or ranges.
std::vector<double> numbersOf(const Json& value) {
  std::vector<double> numbers;
  if (value.is_string()) {
    const std::string fault = parseNumberRange(textOf(value), numbers);
    if (!fault.empty()) refuse(fault);
  } else if (value.is_number()) {
    numbers.push_back(numberOf(value));
  } else {
    for (const Json& one : listOf(value)) numbers.push_back(numberOf(one));
  }
  refuseTwice(numbers);
  return numbers;
}

/// The same of numbers that are whole, where steps of a range are so but for their last bits.
std::vector<double> wholeNumbersOf(const Json& value) {
  constexpr double rounding = 1e-6;
  std::vector<double> numbers = numbersOf(value);
  for (double& number : numbers)
    if (std::abs(number - std::round(number)) < rounding) number = std::round(number);
  refuseTwice(numbers);
  return numbers;
}

int wholeNumberOf(const Json& value, int smallest, int largest) {
  const double number = numberOf(value);
  if (!(number >= smallest && number <= largest && std::floor(number) == number))
    refuse(numberText(number) + " is no whole number from " + std::to_string(smallest) + " to " +
           std::to_string(largest));
  return static_cast<int>(number);
}

double smoothingOf(double a) {
  if (!(a > 0.0 && a <= FaceSurfaceOptions::largestSmoothing))
    refuse("a = " + numberText(a) + " is outside 0 < a <= 1000");
  return a;
}

/// "neutral", or "joy:0.6,surprise:0.4".
StudyPose expressionOf(const std::string& text) {
  StudyPose pose = {text, {}, false, 0.0};
  if (text == Study::neutral) return pose;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    const std::string part = text.substr(begin, end - begin);
    const std::size_t colon = part.find(':');
    const auto intensity =
        colon == std::string::npos ? std::optional<double>(1.0) : parseNumber(std::string_view(part).substr(colon + 1));
    const std::string name = part.substr(0, colon);
    if (!name.empty() && intensity && !(*intensity >= 0.0 && *intensity <= 1.0))
      refuse("the intensity of " + inQuotes(text) + " is outside 0 .. 1");
    if (name.empty() || !intensity)
      refuse(inQuotes(text) + " is no expression; write \"neutral\", \"joy\" or \"joy:0.6,surprise:0.4\"");
    if (!pose.expressions.emplace(name, *intensity).second) refuse(inQuotes(text) + " gives " + name + " twice");
  }
  return pose;
}

void readSchemes(const Json& value, Study& study) {
  study.schemes.clear();
  if (value == all)
    for (const FaceScheme& scheme : faceSchemes()) study.schemes.push_back(scheme.name);
  else
    study.schemes = textsOf(value);
  std::string known;
  for (const FaceScheme& scheme : faceSchemes()) known += (known.empty() ? "" : ", ") + scheme.name;
  for (const std::string& name : study.schemes)
    if (!findFaceScheme(name)) refuse("there is no scheme " + inQuotes(name) + "; there are " + known);
}

void readHarmonics(const Json& value, Study& study) {
  study.harmonics.clear();
  for (const double number : wholeNumbersOf(value))
    study.harmonics.push_back(wholeNumberOf(number, 0, largestHarmonics));
}

void readExpressions(const Json& value, Study& study) {
  for (const std::string& text : textsOf(value)) study.poses.push_back(expressionOf(text));
}

void readFrames(const Json& value, Study& study) {
  refuseUnknownKeys(value, {"file", "frames"});
  if (!value.contains("file")) refuse("the member \"file\" is missing");
  within("\"file\"", [&] { study.fapFile = textOf(value["file"]); });
  study.allFrames = !value.contains("frames") || value["frames"] == all;
  if (study.allFrames) return;
  within("\"frames\"", [&] {
    for (const double number : wholeNumbersOf(value["frames"])) study.poses.push_back({"", {}, true, number});
  });
}

void readResolution(const Json& value, Study& study) {
  if (listOf(value).size() != 2) refuse("two numbers are needed, rows and columns");
  study.rows = wholeNumberOf(value[0], RowLayout::minimumRows, largestSide);
  study.columns = wholeNumberOf(value[1], smallestColumns, largestSide);
}

void readMeasures(const Json& value, Study& study) {
  if (value == all) return;
  study.measures = textsOf(value);
  std::string known;
  for (const std::string& name : caseMeasureNames()) known += (known.empty() ? "" : ", ") + name;
  for (const std::string& name : study.measures)
    if (!isCaseMeasure(name)) refuse("there is no measure " + inQuotes(name) + "; there are " + known);
}

struct Member {
  const char* name;
  void (*read)(const Json& value, Study& study);
};

const Member members[] = {
    {"faces", [](const Json& value, Study& study) { study.faces = textsOf(value); }},
    {"schemes", readSchemes},
    {"a",
     [](const Json& value, Study& study) {
       study.smoothing = numbersOf(value);
       std::for_each(study.smoothing.begin(), study.smoothing.end(), smoothingOf);
     }},
    {"harmonics", readHarmonics},
    {"remainder", [](const Json& value, Study& study) { study.remainder = value.get<bool>(); }},
    {"expressions", readExpressions},
    {"fap", readFrames},
    {"resolution", readResolution},
    {"reference_a", [](const Json& value, Study& study) { study.referenceSmoothing = smoothingOf(numberOf(value)); }},
    {"measures", readMeasures},
};

void refuseUnknownMembers(const Json& root) {
  if (!root.is_object()) refuse("an object {...} is needed where there is " + std::string(root.type_name()));
  const auto isMember = [](const std::string& name) {
    return name == "mien_study" ||
           std::any_of(std::begin(members), std::end(members), [&](const Member& one) { return name == one.name; });
  };
  for (const auto& [name, value] : root.items())
    if (!isMember(name)) refuse("the member " + inQuotes(name) + " is not known to this version");
}

Study studyOf(const Json& root) {
  refuseUnknownMembers(root);
  if (!root.contains("mien_study")) refuse("the member 'mien_study' is missing; it is the version, 1");
  if (!isKnownVersion(root["mien_study"], studyVersion))
    refuse("'mien_study' is no version that this program knows; it knows 1");
  Study study;
  if (root.contains("expressions") || root.contains("fap")) study.poses.clear();
  for (const Member& member : members)
    if (root.contains(member.name))
      within("'" + std::string(member.name) + "'", [&] { member.read(root[member.name], study); });
  if (study.caseCount() > static_cast<double>(Study::mostCases))
    refuse("the product of faces, expressions and frames, harmonics, schemes and a has " +
           numberText(study.caseCount()) + " cases, more than 10,000,000");
  return study;
}

}  // namespace

std::string readStudy(const std::string& text, Study& study, int& line) {
  return parseJson(text, "study", line, [&](const Json& root) { study = studyOf(root); });
}

std::string writeStudy(const Study& study) {
  Json expressions = Json::array(), frames = Json::array();
  for (const StudyPose& pose : study.poses)
    if (pose.isFrame)
      frames.push_back(pose.frame);
    else
      expressions.push_back(pose.expression);
  Json root = {{"mien_study", studyVersion},
               {"faces", study.faces},
               {"schemes", study.schemes},
               {"a", study.smoothing},
               {"harmonics", study.harmonics},
               {"remainder", study.remainder},
               {"resolution", {study.rows, study.columns}},
               {"reference_a", study.referenceSmoothing},
               {"measures", study.measures}};
  if (!expressions.empty()) root["expressions"] = expressions;
  if (!study.fapFile.empty()) root["fap"] = {{"file", study.fapFile}, {"frames", study.allFrames ? Json(all) : frames}};
  return root.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mien
