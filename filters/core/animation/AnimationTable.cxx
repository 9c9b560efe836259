#include "AnimationTable.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "AnimationJson.h"
#include "FAPTable.h"
#include "MotionDirection.h"

namespace mien {

namespace {

constexpr double steepestSlope = 1e3;
constexpr size_t mostParts = 64;  // of an entry; the bundled table has up to 4

int parseCurve(const Json& json) {
  const std::string name = json.get<std::string>();
  const int index = FaceLayout::curveIndex(name);
  if (index < 0) refuse("curve \"" + name + "\" is unknown; curves are C1 .. C22, C22', C23 .. C28");
  return index;
}

double requiredNumber(const Json& json, const std::string& what) {
  if (!json.is_number() || !std::isfinite(json.get<double>())) refuse(what + " must be a number");
  return json.get<double>();
}

Eigen::Vector3d parseVector(const Json& json) {
  if (!json.is_array() || json.size() != 3) refuse("a slope must be three numbers x, y, z");
  const Eigen::Vector3d slope(requiredNumber(json[0], "a slope"), requiredNumber(json[1], "a slope"),
                              requiredNumber(json[2], "a slope"));
  if (slope.cwiseAbs().maxCoeff() > steepestSlope)
    refuse("a slope lies beyond +-1000; 1 is a shift by the FAP value as MPEG-4 counts it");
  return slope;
}

ProfileShape parseShape(const std::string& name) {
  if (name == "linear") return ProfileShape::Linear;
  if (name == "sinusoid") return ProfileShape::Sinusoid;
  if (name == "parabola") return ProfileShape::Parabola;
  refuse("shape \"" + name + "\" is unknown; shapes are linear, sinusoid, parabola and gap");
}

/// "8.3", "8.3+50", "8.4-50" or "2.4|8.3": a feature point (or the first that the face has) and an offset in degrees.
void parsePlace(const std::string& place, ProfileKnot& knot) {
  const size_t sign = place.find_first_of("+-");
  knot.feature = place.substr(0, sign);
  if (knot.feature.empty() || knot.feature.find_first_not_of("0123456789.|") != std::string::npos)
    refuse("\"" + place + "\" is no place along a curve; write a feature point and degrees, such as \"8.3+50\"");
  if (sign == std::string::npos) return;
  const Json degrees = Json::parse(place.substr(place[sign] == '+' ? sign + 1 : sign), nullptr, false);
  knot.offset = requiredNumber(degrees, "the offset in \"" + place + "\"") * M_PI / 180.0;
}

ProfileKnot parseKnot(const Json& json, ProfileShape shape) {
  if (!json.is_array() || json.size() < 2 || json.size() > 3)
    refuse("a knot must be [place, weight] or [place, weight, shape]");
  ProfileKnot knot;
  parsePlace(json[0].get<std::string>(), knot);
  knot.weight = requiredNumber(json[1], "the weight of a knot");
  if (knot.weight < 0.0 || knot.weight > 1.0) refuse("the weight of a knot must lie within 0 and 1");
  knot.shape = json.size() == 3 ? parseShape(json[2].get<std::string>()) : shape;
  return knot;
}

WeightProfile parseProfile(const Json& json) {
  WeightProfile profile;
  refuseUnknownKeys(json, {"shape", "knots", "upper", "lower", "from", "to"});
  const std::string shape = json.at("shape").get<std::string>();
  if (shape == "gap") {
    profile.gapUpper = parseCurve(json.at("upper"));
    profile.gapLower = parseCurve(json.at("lower"));
    profile.gapFrom = json.value("from", std::string());
    profile.gapTo = json.value("to", std::string());
    if (profile.gapUpper >= profile.gapLower) refuse("the upper curve of a gap must come before the lower");
    return profile;
  }
  for (const Json& knot : json.at("knots")) profile.knots.push_back(parseKnot(knot, parseShape(shape)));
  if (profile.knots.size() < 2) refuse("a profile needs at least two knots");
  return profile;
}

Eigen::Vector3d unitDirection(int fap) {
  const Eigen::Vector3d direction = motionDirection(fapDefinition(fap).positiveMotion);
  if (direction.isZero()) refuse("its motion is no shift; give slopes");
  return direction;
}

std::vector<Eigen::Vector3d> parseSlopes(const Json& part, const AnimationEntry& entry) {
  const size_t intervals = entry.intervals.intervals();
  if (!part.contains("slopes")) return std::vector<Eigen::Vector3d>(intervals, unitDirection(entry.fap));
  std::vector<Eigen::Vector3d> slopes;
  for (const Json& slope : part.at("slopes")) slopes.push_back(parseVector(slope));
  if (slopes.size() != intervals)
    refuse("there are " + std::to_string(slopes.size()) + " slopes for " + std::to_string(intervals) + " intervals");
  return slopes;
}

FollowerShape parseFollow(const std::string& name) {
  if (name == "linear") return FollowerShape::Linear;
  if (name == "smooth") return FollowerShape::Smooth;
  refuse("\"follow\" is \"" + name + "\"; it must be linear or smooth");
}

AnimationPart parsePart(const Json& json, const AnimationEntry& entry) {
  AnimationPart part;
  refuseUnknownKeys(json, {"curves", "above", "below", "follow", "slopes", "profile"});
  for (const Json& curve : json.at("curves")) part.curves.push_back(parseCurve(curve));
  if (part.curves.empty()) refuse("a part lists no curves");
  std::sort(part.curves.begin(), part.curves.end());
  part.curves.erase(std::unique(part.curves.begin(), part.curves.end()), part.curves.end());
  if (json.contains("above")) part.above = parseCurve(json["above"]);
  if (json.contains("below")) part.below = parseCurve(json["below"]);
  if (part.above >= part.curves.front()) refuse("\"above\" must name a curve above those moved");
  if (part.below >= 0 && part.below <= part.curves.back()) refuse("\"below\" must name a curve below those moved");
  part.follow = parseFollow(json.value("follow", std::string("linear")));
  part.profile = parseProfile(json.at("profile"));
  part.slopes = parseSlopes(json, entry);
  return part;
}

int parseFap(const Json& json) {
  const double number = requiredNumber(json, "fap");
  if (number != std::floor(number) || number < FAPFrame::firstLowLevel || number > FAPFrame::count)
    refuse("fap must be a whole number from 3 to 68");
  return static_cast<int>(number);
}

std::vector<int> parseFapList(const Json& entry, const char* key) {
  std::vector<int> faps;
  if (!entry.contains(key)) return faps;
  if (!entry.at(key).is_array()) refuse("\"" + std::string(key) + "\" must be a list of FAPs");
  for (const Json& fap : entry.at(key)) faps.push_back(parseFap(fap));
  return faps;
}

std::vector<FAPLoan> parseLoans(const Json& entry) {
  std::vector<FAPLoan> loans;
  if (!entry.contains("lends")) return loans;
  if (!entry.at("lends").is_array()) refuse("\"lends\" must be a list of {\"fap\", \"share\"}");
  for (const Json& loan : entry.at("lends")) {
    refuseUnknownKeys(loan, {"fap", "share"});
    loans.push_back({parseFap(loan.at("fap")), requiredNumber(loan.at("share"), "a share")});
    if (std::abs(loans.back().share) > 1.0) refuse("a share must lie within -1 and 1");
  }
  return loans;
}

void parseEntry(const Json& json, AnimationEntry& entry) {
  refuseUnknownKeys(json, {"fap", "name", "group", "optional", "replaces", "beyond", "lends", "borders", "parts"});
  if (fapDefinition(entry.fap).unit == FAPUnit::Angle)
    refuse("it turns by an angle, which a table of shifts cannot hold");
  const std::string fault = entry.intervals.setBorders(json.at("borders").get<std::vector<double>>());
  if (!fault.empty()) refuse(fault);
  entry.group = json.value("group", std::string());
  entry.optional = json.value("optional", false);
  entry.replaces = parseFapList(json, "replaces");
  entry.beyond = parseFapList(json, "beyond");
  entry.lends = parseLoans(json);
  if (!entry.replaces.empty() && !entry.beyond.empty()) refuse("it may have \"replaces\" or \"beyond\", not both");
  if (json.at("parts").size() > mostParts)
    refuse("it has " + std::to_string(json.at("parts").size()) + " parts; at most " + std::to_string(mostParts) +
           " are read");
  for (const Json& part : json.at("parts")) entry.parts.push_back(parsePart(part, entry));
  if (entry.parts.empty()) refuse("it has no parts");
}

ContactPair parseContact(const Json& json) {
  ContactPair pair;
  refuseUnknownKeys(json, {"name", "upper", "lower", "yields"});
  pair.name = json.at("name").get<std::string>();
  pair.upper = parseCurve(json.at("upper"));
  pair.lower = parseCurve(json.at("lower"));
  if (pair.lower != pair.upper + 1) refuse("contact \"" + pair.name + "\" must join two neighbouring curves");
  const std::string yields = json.at("yields").get<std::string>();
  if (yields != "upper" && yields != "both") refuse("\"yields\" must be upper or both");
  pair.upperYields = yields == "upper";
  return pair;
}

void parseFaps(const Json& json, std::vector<AnimationEntry>& entries) {
  for (size_t i = 0; i < json.size(); ++i) {
    AnimationEntry entry;
    within("entry " + std::to_string(i + 1), [&] { entry.fap = parseFap(json[i].at("fap")); });
    const std::string name = "FAP " + std::to_string(entry.fap);
    const bool twice = std::any_of(entries.begin(), entries.end(), [&](const auto& e) { return e.fap == entry.fap; });
    if (twice) refuse(name + ": there are two entries");
    within(name, [&] { parseEntry(json[i], entry); });
    entries.push_back(std::move(entry));
  }
}

CurveBand parseBand(const Json& json) {
  refuseUnknownKeys(json, {"name", "first", "last"});
  const CurveBand band{parseCurve(json.at("first")), parseCurve(json.at("last"))};
  if (band.first > band.last) refuse("\"first\" must not come after \"last\"");
  return band;
}

/// Relations need no order of their own: whom an entry looks at must stand before it, so none looks in a circle.
void checkRelations(const std::vector<AnimationEntry>& entries) {
  std::vector<int> before;
  const auto known = [&](const std::vector<int>& faps, int fap) {
    return std::find(faps.begin(), faps.end(), fap) != faps.end();
  };
  std::vector<int> all;
  for (const AnimationEntry& entry : entries) all.push_back(entry.fap);
  for (const AnimationEntry& entry : entries) {
    const std::string name = "FAP " + std::to_string(entry.fap) + ": ";
    for (const std::vector<int>* list : {&entry.replaces, &entry.beyond})
      for (int fap : *list)
        if (!known(before, fap)) refuse(name + "the entry of FAP " + std::to_string(fap) + " must stand before it");
    for (const FAPLoan& loan : entry.lends)
      if (!known(all, loan.fap) || loan.fap == entry.fap)
        refuse(name + "it lends to FAP " + std::to_string(loan.fap) + ", which has no entry of its own");
    before.push_back(entry.fap);
  }
}

struct TableContent {
  int version = 0;
  std::vector<AnimationEntry> entries;
  std::vector<ContactPair> contacts;
  std::vector<CurveBand> sideways;
};

void parseTable(const Json& root, TableContent& content) {
  if (!root.is_object() || root.value("format", Json()) != "mien animation table")
    refuse("\"format\" is not \"mien animation table\"");
  if (!isKnownVersion(root.value("version", Json()), AnimationTable::version))
    refuse("its version is none of those known, 1 to " + std::to_string(AnimationTable::version));
  content.version = root["version"].get<int>();
  refuseUnknownKeys(root, {"format", "version", "contacts", "sideways", "faps"});
  if (!root.contains("faps") || !root["faps"].is_array()) refuse("it has no list \"faps\"");
  if (root["faps"].empty()) refuse("its list \"faps\" is empty, nothing would move; add an entry");
  if (root.contains("contacts"))
    within("contacts", [&] {
      for (const Json& pair : root["contacts"]) content.contacts.push_back(parseContact(pair));
    });
  if (root.contains("sideways"))
    within("sideways", [&] {
      for (const Json& band : root["sideways"]) content.sideways.push_back(parseBand(band));
    });
  parseFaps(root["faps"], content.entries);
  checkRelations(content.entries);
}

}  // namespace

std::string AnimationTable::parse(const std::string& json) {
  TableContent content;
  const std::string fault =
      parseJson(json, "animation table", faultLine_, [&](const Json& root) { parseTable(root, content); });
  if (!fault.empty()) return fault;
  fileVersion_ = content.version;
  entries_ = std::move(content.entries);
  contacts_ = std::move(content.contacts);
  sideways_ = std::move(content.sideways);
  return {};
}

const AnimationEntry* AnimationTable::entry(int fap) const {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e.fap == fap; });
  return found == entries_.end() ? nullptr : &*found;
}

}  // namespace mien
