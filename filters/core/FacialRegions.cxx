#include "FacialRegions.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace mien {

namespace {

using Json = nlohmann::json;
constexpr int knownVersion = 1;

/// 0 below 0, 1 above 1, with continuous slope.
double smoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double finite(const Json& json, const char* key, double smallest, double largest) {
  const double value = json.at(key).get<double>();
  if (!(value >= smallest && value <= largest))
    throw std::invalid_argument(std::string(key) + " must be a number from " + std::to_string(smallest) + " to " +
                                std::to_string(largest));
  return value;
}

Eigen::Vector2d pair(const Json& json, const char* key) {
  const auto values = json.at(key).get<std::array<double, 2>>();
  const Eigen::Vector2d result(values[0], values[1]);
  if (!result.allFinite()) throw std::invalid_argument(std::string(key) + " must be two finite numbers");
  return result;
}

std::array<double, 2> ascending(const Json& json, const char* key) {
  const Eigen::Vector2d range = pair(json, key);
  if (range[0] >= range[1]) throw std::invalid_argument(std::string(key) + " must be two ascending numbers");
  return {range[0], range[1]};
}

}  // namespace

std::string FacialRegions::parse(const std::string& text) {
  FacialRegions parsed;
  try {
    const Json json = Json::parse(text);
    parsed.version_ = json.at("version").get<int>();
    if (parsed.version_ != knownVersion) throw std::invalid_argument("version must be 1, the only one known");
    const Json& regions = json.at("regions");
    if (!regions.is_array() || regions.size() != count) throw std::invalid_argument("there must be 16 regions");
    for (const Json& region : regions) {
      const int id = region.at("region").get<int>(), mirror = region.at("mirror").get<int>();
      if (std::min(id, mirror) < 1 || std::max(id, mirror) > count)
        throw std::invalid_argument("region numbers run from 1 to 16");
      if (parsed.mirrored_[id - 1]) throw std::invalid_argument("region " + std::to_string(id) + " is given twice");
      parsed.mirrored_[id - 1] = mirror;
      parsed.names_[id - 1] = region.at("name").get<std::string>();
      parsed.centres_[id - 1] = pair(region, "centre");
    }
    for (int id = 1; id <= count; ++id)
      if (parsed.mirrored(parsed.mirrored(id)) != id)
        throw std::invalid_argument("region " + std::to_string(id) + " is not the mirror of its mirror");
    parsed.blend_ = finite(json, "blend", 1e-3, 10.0);
    const Json &outline = json.at("outline"), &lips = json.at("lips"), &back = json.at("back");
    parsed.outlineCentre_ = pair(outline, "centre");
    parsed.outlineRadii_ = pair(outline, "radii");
    if (parsed.outlineRadii_.minCoeff() <= 0.0) throw std::invalid_argument("radii must be positive");
    parsed.outlineExponent_ = finite(outline, "exponent", 1.0, 20.0);
    parsed.outlineFade_ = finite(outline, "fade", 1e-3, 10.0);
    parsed.lipCentre_ = pair(lips, "centre");
    parsed.lipHalfWidth_ = finite(lips, "half_width", 0.0, 10.0);
    parsed.lipReach_ = finite(lips, "reach", 1e-3, 10.0);
    parsed.lipShift_ = finite(lips, "shift", 0.0, 10.0);
    parsed.depthRange_ = ascending(back, "depth");
    parsed.normalRange_ = ascending(back, "normal_z");
  } catch (const std::exception& error) {
    return std::string("region map: ") + error.what();
  }
  *this = parsed;
  return {};
}

Eigen::Vector2d FacialRegions::lookup(const Eigen::Vector2d& point, LipSide side) const {
  if (side == 0.0) return point;
  const double x = std::max(std::abs(point.x() - lipCentre_.x()) - lipHalfWidth_, 0.0);
  const double distance = std::hypot(x, point.y() - lipCentre_.y());
  return {point.x(), point.y() + side * lipShift_ * smoothStep(1.0 - distance / lipReach_)};
}

int FacialRegions::nearest(const Eigen::Vector2d& point, LipSide side) const {
  const Eigen::Vector2d at = lookup(point, side);
  const auto closer = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - at).squaredNorm() < (b - at).squaredNorm();
  };
  return 1 + static_cast<int>(std::min_element(centres_.begin(), centres_.end(), closer) - centres_.begin());
}

FacialRegions::Weights FacialRegions::weights(const Eigen::Vector2d& point, LipSide side) const {
  const Eigen::Vector2d at = lookup(point, side);
  Weights result{};
  for (int i = 0; i < count; ++i) result[i] = (centres_[i] - at).norm();
  const double nearest = *std::min_element(result.begin(), result.end());
  double sum = 0.0;
  for (double& value : result) sum += value = smoothStep(1.0 - (value - nearest) / blend_);
  for (double& value : result) value /= sum;
  return result;
}

double FacialRegions::outlineWeight(const Eigen::Vector2d& point) const {
  const Eigen::Array2d ratio = ((point - outlineCentre_).array() / outlineRadii_.array()).abs();
  const double radius = std::pow(ratio.pow(outlineExponent_).sum(), 1.0 / outlineExponent_);
  return smoothStep(1.0 - (radius - 1.0) / outlineFade_);
}

double FacialRegions::facingWeight(double z, double normalZ) const {
  const auto within = [](double value, const std::array<double, 2>& range) {
    return smoothStep((value - range[0]) / (range[1] - range[0]));
  };
  return 1.0 - (1.0 - within(z, depthRange_)) * (1.0 - within(normalZ, normalRange_));
}

DeformationTable FacialRegions::mirrored(const DeformationTable& table) const {
  DeformationTable result = table;
  for (int i = 0; i < count; ++i) {
    const int other = mirrored_[i] - 1;
    result.maps[i] = table.maps[other].mirrored();
    if (table.deviations) result.deviations->at(i) = table.deviations->at(other);
  }
  return result;
}

}  // namespace mien
