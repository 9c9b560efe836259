#include "WeightProfile.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

struct PlacedKnot {
  double v, weight;
  ProfileShape shape;
};

/// The first feature point that the face has of those told as "2.4|8.3".
const FeaturePoint* firstKnown(const FaceCurves& face, const std::string& names) {
  for (size_t begin = 0; begin <= names.size();) {
    const size_t end = std::min(names.find('|', begin), names.size());
    if (const FeaturePoint* feature = face.feature(names.substr(begin, end - begin))) return feature;
    begin = end + 1;
  }
  return nullptr;
}

std::string placeKnots(const std::vector<ProfileKnot>& knots, const FaceCurves& face, std::vector<PlacedKnot>& placed) {
  for (const ProfileKnot& knot : knots) {
    const FeaturePoint* feature = firstKnown(face, knot.feature);
    if (!feature) return "the face has no feature point " + knot.feature;
    const double v = knot.offset + feature->v;
    const bool again = !placed.empty() && placed.back().v == v && placed.back().weight == knot.weight;
    if (again) placed.pop_back();  // "2.4|8.3" beside 8.3 on a face without 2.4
    if (!placed.empty() && !(placed.back().v < v))
      return "the knots of its profile do not ascend in v on this face, at the one of feature point " + knot.feature;
    placed.push_back({v, knot.weight, knot.shape});
  }
  return {};
}

double shapeValue(const PlacedKnot& left, const PlacedKnot& right, double v) {
  const double s = (v - left.v) / (right.v - left.v);
  switch (left.shape) {
    case ProfileShape::Linear:
      return s;
    case ProfileShape::Sinusoid:
      return std::pow(std::sin(0.5 * M_PI * s), 2);
    case ProfileShape::Parabola:
      break;
  }
  const bool vertexLeft = std::abs(left.v - M_PI) <= std::abs(right.v - M_PI);
  return vertexLeft ? s * s : 1.0 - (1.0 - s) * (1.0 - s);
}

double evaluate(const std::vector<PlacedKnot>& knots, double v) {
  for (size_t i = 0; i + 1 < knots.size(); ++i)
    if (v >= knots[i].v && v <= knots[i + 1].v)
      return knots[i].weight + (knots[i + 1].weight - knots[i].weight) * shapeValue(knots[i], knots[i + 1], v);
  return 0.0;
}

/// The height of one curve over another at every sample; rounding of touching curves is no gap.
Eigen::VectorXd gapBetween(const ClosedCurves& curves, int upper, int lower) {
  return (curves.curve(upper).col(1) - curves.curve(lower).col(1)).cwiseMax(0.0);
}

/// Copies the gap from the column of the feature outwards until it is closed, grows again or reaches the middle.
void copyOpening(const Eigen::VectorXd& gap, int start, int step, double middle, Eigen::VectorXd& opening) {
  const int k = static_cast<int>(gap.size());
  double least = gap[start], widest = gap[start];
  for (int j = start; j >= 0 && j < k && (j - middle) * (start - middle) > 0.0; j += step) {
    const bool growsAgain = gap[j] > least && least < 0.7 * widest;
    if (growsAgain || gap[j] <= 0.0) return;
    opening[j] = gap[j];
    least = std::min(least, gap[j]);
    widest = std::max(widest, gap[j]);
  }
}

/// The gap between the corners of an eye, falling to 0 over `cornerTaper` beyond them.
void copyBetween(const Eigen::VectorXd& gap, double from, double to, Eigen::VectorXd& opening) {
  constexpr double cornerTaper = 12.0 * M_PI / 180.0;
  for (int j = 0; j < gap.size(); ++j) {
    const double v = 2.0 * M_PI * j / static_cast<double>(gap.size());
    const double beyond = std::max({from - v, v - to, 0.0}) / cornerTaper;
    if (beyond < 1.0) opening[j] = gap[j] * std::pow(std::cos(0.5 * M_PI * beyond), 2);
  }
}

std::string sampleGap(const WeightProfile& profile, const FaceCurves& face, const FeaturePoint& feature,
                      Eigen::VectorXd& weights) {
  const int k = face.curves.pointsPerCurve;
  const Eigen::VectorXd gap = gapBetween(face.curves, profile.gapUpper, profile.gapLower);
  const FeaturePoint* from = firstKnown(face, profile.gapFrom);
  const FeaturePoint* to = firstKnown(face, profile.gapTo);
  const int start = static_cast<int>(std::lround(feature.v * k / (2.0 * M_PI))) % k;
  if (from && to)
    copyBetween(gap, from->v, to->v, weights);
  else
    for (int step : {-1, 1}) copyOpening(gap, start, step, 0.5 * k, weights);
  const double atFeature = cardinalWeights(k, feature.v).dot(weights);
  if (!(atFeature > 1e-6)) return "there is no opening between its curves at feature point " + feature.id;
  weights /= atFeature;
  return {};
}

}  // namespace

std::vector<double> WeightProfile::exactPlaces(const FaceCurves& face, const std::vector<int>& curves) const {
  std::vector<double> places;
  for (const ProfileKnot& knot : knots) {
    const FeaturePoint* feature = knot.weight == 1.0 && knot.offset == 0.0 ? firstKnown(face, knot.feature) : nullptr;
    if (feature && std::count(curves.begin(), curves.end(), feature->curve) > 0) places.push_back(feature->v);
  }
  return places;
}

std::string WeightProfile::sample(const FaceCurves& face, const FeaturePoint& feature, Eigen::VectorXd& weights) const {
  const int k = face.curves.pointsPerCurve;
  weights = Eigen::VectorXd::Zero(k);
  if (followsGap()) return sampleGap(*this, face, feature, weights);
  std::vector<PlacedKnot> placed;
  const std::string fault = placeKnots(knots, face, placed);
  for (int j = 0; j < k && fault.empty(); ++j) weights[j] = evaluate(placed, 2.0 * M_PI * j / k);
  return fault;
}

}  // namespace mien
