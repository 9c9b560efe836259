#include "MouthInside.h"

#include <algorithm>
#include <cmath>

#include "FaceLayout.h"
#include "MouthCorners.h"

namespace mien {

namespace {

constexpr double fullTurn = 6.283185307179586;

/// The samples of a curve from one corner of the mouth to the other, both counted.
std::pair<int, int> samplesBetween(const MouthCorners& corners, int pointsPerCurve) {
  const double step = fullTurn / pointsPerCurve;
  return {static_cast<int>(std::floor(corners.begin / step)), static_cast<int>(std::ceil(corners.end / step))};
}

int other(int lip) {
  return lip == FaceLayout::upperLip ? FaceLayout::lowerLip : FaceLayout::upperLip;
}

}  // namespace

MouthInside::MouthInside(const FaceCurves& face) {
  const MouthCorners corners(face);
  if (!(corners.end > corners.begin)) return;
  const int count = face.curves.pointsPerCurve;
  const auto [first, last] = samplesBetween(corners, count);
  const auto at = [&](int curve, int sample) -> Eigen::Vector3d {
    return face.curves.points.row(curve * count + (sample % count + count) % count);
  };
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (int i = first; i <= last; ++i) {
    const Eigen::Vector3d upper = at(FaceLayout::upperLip, i), lower = at(FaceLayout::lowerLip, i);
    gap = std::max(gap, (upper - lower).norm());
    middle += 0.5 * (upper + lower) / (last - first + 1);
  }
  if (gap < leastGap) return;
  const Eigen::Vector3d axis = face.curves.curve(FaceLayout::upperLip).colwise().mean().transpose();
  const Eigen::Vector3d inwards = (axis - middle).normalized();
  points.push_back(middle + depth * inwards);
  for (int curve : {FaceLayout::upperLip, FaceLayout::lowerLip})
    for (int i = first; i <= last; ++i) {
      const Eigen::Vector3d outwards = at(curve, i) - at(other(curve), i);
      const double further = std::min(overlap, 0.5 * outwards.norm());
      points.push_back(at(curve, i) + retreat * inwards + further * outwards.stableNormalized());
      const int newest = static_cast<int>(points.size()) - 1;
      if (i > first) triangles.push_back({0, newest - 1, newest});
    }
}

}  // namespace mien
