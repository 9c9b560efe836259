#include "MarkerFileOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "Arguments.h"
#include "FaceFrame.h"
#include "Failure.h"
#include "NumberText.h"
#include "PupilMarkers.h"
#include "TextFileReader.h"

namespace mien {

namespace {

constexpr std::size_t largestText = 256'000'000;  // four million markers

/// "x,y[,z],x,y[,z]": the subject's left pupil first.
EyePupils parsePlaces(const std::string& option, const std::vector<std::string>& parts) {
  const int axes = static_cast<int>(parts.size()) / 2;
  EyePupils places;
  for (int axis = 0; axis < axes; ++axis) {
    places.left[axis] = parseNumber(option, parts[axis]);
    places.right[axis] = parseNumber(option, parts[axes + axis]);
  }
  if (places.left == places.right)
    throw ValueFailure(option + ": both pupils lie at the same place; give the subject's left one, then the right one");
  return places;
}

bool arePlaces(const std::vector<std::string>& parts) {
  return parts.size() == 4 || parts.size() == 6;
}

/// Two numbers are more often half of two places than names.
std::string withPlacesHint(const std::string& fault, const MarkerOptions& options) {
  const bool numbers =
      parseNumber(std::string_view(options.leftPupil)) && parseNumber(std::string_view(options.rightPupil));
  if (!numbers || fault.find("pupil " + options.leftPupil) == std::string::npos) return fault;
  return fault + "; --pupils " + options.leftPupil + "," + options.rightPupil +
         " names two markers, places are x,y,x,y or x,y,z,x,y,z";
}

ValueFailure noPupils(const std::string& option, const std::string& text, bool names) {
  return ValueFailure(option + " '" + text + "' is no pair of pupils; give " +
                      (names ? "the names of two markers, or " : "") +
                      "x,y,x,y or x,y,z,x,y,z, the subject's left pupil first");
}

}  // namespace

void MarkerFileOptions::addTo(CLI::App& command, bool twoStates) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->group("Reading faces");
  };
  CLI::Option* pupils = add("--pupils", pupils_,
                            "The subject's left and right pupil: names of two markers, or their places x,y[,z],x,y[,z] "
                            "[pupil_left,pupil_right]");
  if (twoStates)
    add("--expression-pupils", expressionPupils_, "Places of the pupils in the expression [those of --pupils]")
        ->needs(pupils);
  addRegionsTo(command);
  command.add_flag("--y-down", yDown_, "y runs downwards, as in images")->group("Reading faces");
  command.add_flag("--mirrored", mirrored_, "The pictures show the face as a mirror does")->group("Reading faces");
}

void MarkerFileOptions::addRegionsTo(CLI::App& command) {
  command
      .add_option(
          "--regions", regionFile_,
          "Region map of your own, FILE.json as doc/deformation_tables.md describes it [the 16 regions compiled "
          "in]")
      ->group("Reading faces");
}

MarkerFileOptions MarkerFileOptions::regionsOnly() const {
  MarkerFileOptions options;
  options.regionFile_ = regionFile_;
  return options;
}

void MarkerFileOptions::refuseForTables(bool isRecording, const std::string& file, bool regions) const {
  if (isRecording) return;
  const std::string given = yDown_                             ? "--y-down"
                            : mirrored_                        ? "--mirrored"
                            : !pupils_.empty()                 ? "--pupils"
                            : !regions && !regionFile_.empty() ? "--regions"
                                                               : "";
  if (!given.empty()) throw ValueFailure(given + " is for recordings of markers; " + file + " is a table");
}

MarkerOptions MarkerFileOptions::markers() const {
  MarkerOptions options;
  options.yDown = yDown_;
  options.mirrored = mirrored_;
  if (pupils_.empty()) return options;
  const std::vector<std::string> parts = splitText(pupils_, ',');
  if (parts.size() == 2) {
    options.leftPupil = parts[0];
    options.rightPupil = parts[1];
  } else if (arePlaces(parts)) {
    options.neutralPupils = options.expressionPupils = parsePlaces("--pupils", parts);
  } else {
    throw noPupils("--pupils", pupils_, true);
  }
  if (expressionPupils_.empty()) return options;
  const std::vector<std::string> others = splitText(expressionPupils_, ',');
  if (!arePlaces(others) || !arePlaces(parts)) throw noPupils("--expression-pupils", expressionPupils_, false);
  options.expressionPupils = parsePlaces("--expression-pupils", others);
  return options;
}

void MarkerFileOptions::requirePupilsInSpace() const {
  for (const std::string* text : {&pupils_, &expressionPupils_})
    if (!text->empty() && splitText(*text, ',').size() != 6)
      throw ValueFailure("pupils '" + *text +
                         "' are no places of a surface; give x,y,z,x,y,z, the subject's left pupil first");
}

FacialRegions MarkerFileOptions::regions() const {
  FacialRegions regions;
  const std::string fault = readRegions(regionFile_, regions);
  if (!fault.empty()) throw FileFailure(fault);
  return regions;
}

void MarkerFileOptions::tellStillHead(const std::string& file) const {
  if (markers().neutralPupils && expressionPupils_.empty())
    std::cerr << "mien: " << file
              << ": the pupils are taken to be at the same places in the expression, the head as still; else give "
                 "--expression-pupils\n";
}

std::string surfaceFault(const std::string& fault) {
  const std::size_t at = fault.find("there are no pupils");
  return at == std::string::npos
             ? fault
             : fault.substr(0, at) +
                   "nothing tells where its pupils are; give the 68 landmarks (--landmarks FILE.csv) "
                   "or both pupils (--pupils x,y,z,x,y,z, the subject's left first)";
}

std::string readMarkerText(const std::string& file) {
  std::string text;
  const std::string fault = readTextFile(file, largestText, text);
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  text.shrink_to_fit();
  return text;
}

MarkerTable readRecording(const std::string& file, const MarkerFileOptions& options) {
  return parseRecording(readMarkerText(file), file, options);
}

MarkerTable parseRecording(const std::string& text, const std::string& file, const MarkerFileOptions& options) {
  MarkerTable markers;
  const std::string fault = markers.parse(text, options.markers());
  if (!fault.empty()) throw FileFailure(file + ":" + withPlacesHint(fault, options.markers()));
  takeOutGivenPupils(markers, options, file);
  return markers;
}

void takeOutGivenPupils(MarkerTable& markers, const MarkerFileOptions& options, const std::string& file) {
  if (!options.markers().neutralPupils) return;
  options.tellStillHead(file);
  std::string names;
  for (const std::string& name : takeOutPupils(markers)) names += (names.empty() ? "" : ", ") + name;
  if (!names.empty())
    std::cerr << "mien: " << file << ": " << names << ": on a pupil that was given by place, so left out of the fit\n";
}

PointTable readPoints(const std::string& file, const MarkerFileOptions& options) {
  PointTable points;
  const std::string fault = points.parse(readMarkerText(file), options.markers());
  if (!fault.empty()) throw FileFailure(file + ":" + fault);
  return points;
}

}  // namespace mien
