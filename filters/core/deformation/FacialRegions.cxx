#include "FacialRegions.h"

#include <algorithm>
#include <cmath>

#include "JsonText.h"
#include "SmoothStep.h"

namespace mien {

namespace {

constexpr int knownVersion = 1;
constexpr double rounding = 0.1;  // of the corner where places beyond the outline stop moving outwards, of its size

double finite(const Json& json, const char* key, double smallest, double largest) {
  const double value = json.at(key).get<double>();
  if (!(value >= smallest && value <= largest))
    refuse(std::string(key) + " must be a number from " + std::to_string(smallest) + " to " + std::to_string(largest));
  return value;
}

Eigen::Vector2d pair(const Json& json, const char* key) {
  const auto values = json.at(key).get<std::array<double, 2>>();
  const Eigen::Vector2d result(values[0], values[1]);
  if (!result.allFinite()) refuse(std::string(key) + " must be two finite numbers");
  return result;
}

std::array<double, 2> ascending(const Json& json, const char* key) {
  const Eigen::Vector2d range = pair(json, key);
  if (range[0] >= range[1]) refuse(std::string(key) + " must be two ascending numbers");
  return {range[0], range[1]};
}

FacialRegions::Slit slit(const Json& json) {
  FacialRegions::Slit result;
  result.reach = finite(json, "reach", 1e-3, 10.0);
  result.separation = finite(json, "separation", 0.0, 10.0);
  if (json.contains("aside")) result.aside = finite(json, "aside", 0.0, 10.0);
  for (const auto& [key, side] : {std::pair("upper", 1.0), {"lower", -1.0}})
    for (const int region : json.at(key).get<std::vector<int>>()) {
      if (region < 1 || region > FacialRegions::count) refuse("region numbers run from 1 to 16");
      if (result.sides[region - 1] != 0.0) refuse("region " + std::to_string(region) + " is given twice beside a slit");
      result.sides[region - 1] = side;
    }
  return result;
}

}  // namespace

struct FacialRegions::Reader {
  static void read(const Json& root, FacialRegions& parsed) {
    parsed.version_ = root.at("version").get<int>();
    if (parsed.version_ != knownVersion) refuse("version must be 1, the only one known");
    readRegions(root.at("regions"), parsed);
    parsed.blend_ = finite(root, "blend", 1e-3, 10.0);
    within("outline", [&] { readOutline(root.at("outline"), parsed); });
    within("lips", [&] { parsed.lips_ = slit(root.at("lips")); });
    within("lids", [&] { parsed.lids_ = slit(root.at("lids")); });
    within("back", [&] { parsed.depthRange_ = ascending(root.at("back"), "depth"); });
  }

 private:
  static void readOutline(const Json& outline, FacialRegions& parsed) {
    parsed.outlineCentre_ = pair(outline, "centre");
    const Eigen::Vector2d radii = pair(outline, "radii");
    if (radii.minCoeff() <= 0.0) refuse("radii must be positive");
    parsed.outlineAside_ = radii.x();
    parsed.above_ = {radii.y(), finite(outline, "exponent", 1.0, 20.0)};
    parsed.below_ = parsed.above_;
    if (outline.contains("below"))
      within("below", [&] {
        const Json& below = outline.at("below");
        parsed.below_ = {finite(below, "radius", 1e-3, 100.0), finite(below, "exponent", 1.0, 20.0)};
      });
    if (outline.contains("begin")) parsed.outlineBegin_ = finite(outline, "begin", 1e-3, 10.0);
    parsed.outlineFade_ = finite(outline, "fade", 1e-3, 10.0);
  }

  static void readRegions(const Json& regions, FacialRegions& parsed) {
    if (!regions.is_array() || regions.size() != count) refuse("there must be 16 regions");
    int row = 0;
    for (const Json& region : regions)
      within("entry " + std::to_string(++row) + " of regions", [&] { readRegion(region, parsed); });
    for (int id = 1; id <= count; ++id)
      if (parsed.mirrored(parsed.mirrored(id)) != id)
        refuse("region " + std::to_string(id) + " is not the mirror of its mirror");
  }

  static void readRegion(const Json& region, FacialRegions& parsed) {
    const int id = region.at("region").get<int>(), mirror = region.at("mirror").get<int>();
    if (std::min(id, mirror) < 1 || std::max(id, mirror) > count) refuse("region numbers run from 1 to 16");
    if (parsed.mirrored_[id - 1]) refuse("region " + std::to_string(id) + " is given twice");
    parsed.mirrored_[id - 1] = mirror;
    parsed.names_[id - 1] = region.at("name").get<std::string>();
    parsed.centres_[id - 1] = pair(region, "centre");
  }
};

std::string FacialRegions::parse(const std::string& text, int* faultLine) {
  FacialRegions parsed;
  int line = 0;
  const std::string fault = parseJson(text, "region map", line, [&](const Json& root) { Reader::read(root, parsed); });
  if (faultLine) *faultLine = line;
  if (fault.empty()) *this = parsed;
  return fault;
}

FacialRegions::Weights FacialRegions::distances(const Eigen::Vector2d& point, const FaceSide& side) const {
  const auto further = [](const Slit& slit, int i, double on) {
    return slit.sides[i] == 0.0 ? slit.aside * std::abs(on) : slit.separation * std::max(-slit.sides[i] * on, 0.0);
  };
  Weights result;
  for (int i = 0; i < count; ++i)
    result[i] = (centres_[i] - point).norm() + further(lips_, i, side.lips) + further(lids_, i, side.lids);
  return result;
}

int FacialRegions::nearest(const Eigen::Vector2d& point, const FaceSide& side) const {
  const Weights all = this->distances(point, side);
  return 1 + static_cast<int>(std::min_element(all.begin(), all.end()) - all.begin());
}

FacialRegions::Weights FacialRegions::weights(const Eigen::Vector2d& point, const FaceSide& side) const {
  Weights result = this->distances(point, side);
  const double nearest = *std::min_element(result.begin(), result.end());
  double sum = 0.0;
  for (double& value : result) sum += value = smoothStep(1.0 - (value - nearest) / blend_);
  for (double& value : result) value /= sum;
  return result;
}

double FacialRegions::outlineRadius(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d offset = point - outlineCentre_;
  const HalfOutline& half = offset.y() < 0.0 ? below_ : above_;
  return std::pow(std::pow(std::abs(offset.x()) / outlineAside_, half.exponent) +
                      std::pow(std::abs(offset.y()) / half.radius, half.exponent),
                  1.0 / half.exponent);
}

double FacialRegions::outlineWeight(const Eigen::Vector2d& point) const {
  return smoothStep(1.0 - (this->outlineRadius(point) - outlineBegin_) / outlineFade_);
}

Eigen::Vector2d FacialRegions::followed(const Eigen::Vector2d& point) const {
  const double radius = this->outlineRadius(point), beyond = radius - (1.0 - rounding);
  if (beyond <= 0.0) return point;
  // A parabola from slope 1 at 1 - rounding to slope 0 at 1 + rounding.
  const double kept = beyond < 2.0 * rounding ? radius - beyond * beyond / (4.0 * rounding) : 1.0;
  return outlineCentre_ + kept / radius * (point - outlineCentre_);
}

double FacialRegions::depthWeight(double z) const {
  return smoothStep((z - depthRange_[0]) / (depthRange_[1] - depthRange_[0]));
}

DeformationTable FacialRegions::mirrored(const DeformationTable& table) const {
  DeformationTable result = table;
  for (int i = 0; i < count; ++i) {
    const int other = mirrored_[i] - 1;
    result.maps[i] = table.maps[other].mirrored();
    if (table.deviations) result.deviations->at(i) = table.deviations->at(other);
    if (table.counts) result.counts->at(i) = table.counts->at(other);
  }
  return result;
}

}  // namespace mien
