#include "TableDeformation.h"

#include <algorithm>
#include <cmath>

#include "SmoothStep.h"

namespace mien {

namespace {

constexpr std::size_t pointsBetweenReports = 65536;

// Distances from a region's centre, pupil units, for tables whose points are not known.
constexpr double fullTrust = 0.6, noTrust = 1.1;
// Distances from the midline: beside the mouth corners such tables run away first, and fold the jaw.
constexpr double fullTrustAside = 1.2, noTrustAside = 2.0;

}  // namespace

double coverageOf(const FacialRegions& regions, const Eigen::Vector3d& place, const DeformationPoint& point) {
  return point.stays ? 0.0 : regions.outlineWeight(place.head<2>()) * regions.depthWeight(place.z());
}

bool isFitted(const FacialRegions& regions, const Eigen::Vector3d& place, const DeformationPoint& point) {
  return !point.stays && regions.covers(place.head<2>()) && regions.depthWeight(place.z()) == 1.0;
}

TableDeformation::TableDeformation(const std::vector<DeformationPoint>& points, const PupilNormalisation& pupils,
                                   const FacialRegions& regions, bool smooth, const Progress& progress) {
  const Eigen::Vector3d origin = pupils.invert(Eigen::Vector3d::Zero());
  toFace_.col(0) = (pupils.invert(Eigen::Vector3d::UnitX()) - origin).head<2>();
  toFace_.col(1) = (pupils.invert(Eigen::Vector3d::UnitY()) - origin).head<2>();
  places_.reserve(points.size());
  shares_.reserve(2 * points.size());
  for (const DeformationPoint& point : points) {
    if (places_.size() % pointsBetweenReports == 0 && !goesOn(progress, double(places_.size()) / points.size())) return;
    const Eigen::Vector3d p = pupils.apply(point.position);
    const Eigen::Vector2d at = p.head<2>();
    Place place{regions.followed(at), coverageOf(regions, p, point), static_cast<std::uint32_t>(shares_.size()), 0};
    if (place.coverage > 0.0 && point.region) {
      addShare(regions, at, point.region, 1.0);
    } else if (place.coverage > 0.0 && smooth) {
      const FacialRegions::Weights weights = regions.weights(at, point.side);
      for (int i = 0; i < FacialRegions::count; ++i)
        if (weights[i] > 0.0) addShare(regions, at, i + 1, weights[i]);
    } else if (place.coverage > 0.0) {
      addShare(regions, at, regions.nearest(at, point.side), 1.0);
    }
    place.count = static_cast<std::uint32_t>(shares_.size()) - place.first;
    places_.push_back(place);
  }
}

void TableDeformation::addShare(const FacialRegions& regions, const Eigen::Vector2d& point, int region, double weight) {
  const double distance = (point - regions.centre(region)).norm();
  const double trust = smoothStep((noTrust - distance) / (noTrust - fullTrust)) *
                       smoothStep((noTrustAside - std::abs(point.x())) / (noTrustAside - fullTrustAside));
  shares_.push_back({weight, weight * trust, region - 1});
}

void TableDeformation::displacements(const DeformationTable& table, double limit, double strength, std::size_t begin,
                                     std::size_t end, Eigen::Vector2d* result) const {
  std::array<QuadraticMap::Coefficients, FacialRegions::count> moves;
  for (int i = 0; i < FacialRegions::count; ++i) moves[i] = table.maps[i].coefficients - QuadraticMap::identity();
  const double longest = displacementLimit * limit;
  const auto weight = table.largestDisplacement > 0.0 ? &Share::weight : &Share::nearWeight;
  for (std::size_t i = begin; i < end; ++i) {
    const Place& place = places_[i];
    const QuadraticMap::Basis basis = QuadraticMap::basis(place.point);
    Eigen::Vector2d move = Eigen::Vector2d::Zero();
    for (std::uint32_t s = place.first; s < place.first + place.count; ++s)
      move += shares_[s].*weight * (moves[shares_[s].region] * basis);
    const double length = move.norm();
    if (length > longest) move *= longest / length;
    result[i - begin] = toFace_ * (strength * place.coverage * move);
  }
}

double fittedDisplacement(const DeformationTable& table, const FacialRegions& regions) {
  if (table.largestDisplacement > 0.0) return table.largestDisplacement;
  constexpr double reach = 0.4;
  constexpr int directions = 16;
  double largest = 0.0;
  for (int region = 1; region <= FacialRegions::count; ++region)
    for (int i = 0; i <= directions; ++i) {
      const double angle = 2.0 * 3.14159265358979 * i / directions;
      const Eigen::Vector2d offset = i == directions
                                         ? Eigen::Vector2d(0.0, 0.0)
                                         : Eigen::Vector2d(reach * std::cos(angle), reach * std::sin(angle));
      const Eigen::Vector2d point = regions.centre(region) + offset;
      largest = std::max(largest, (table.maps[region - 1].apply(point) - point).norm());
    }
  return largest;
}

}  // namespace mien
