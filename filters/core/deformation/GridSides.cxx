#include "GridSides.h"

#include <algorithm>
#include <cmath>

#include "SmoothStep.h"

namespace mien {

namespace {

constexpr double eyeHalfWidth = 0.45;

double fade(double t) {
  return smoothStep(1.0 - t);
}

}  // namespace

std::vector<FaceSide> gridSides(const GridSlits& slits, const std::function<Eigen::Vector3d(int, int)>& point,
                                const FacialRegions& regions, const PupilNormalisation& pupils) {
  std::vector<FaceSide> sides(static_cast<std::size_t>(slits.rows) * slits.columns);
  const auto lips = [&](int column) {
    const double middle = 0.5 * (slits.openBegin + slits.openEnd), half = 0.5 * (slits.openEnd - slits.openBegin);
    const double profile = 1.0 - std::pow((column - middle) / half, 4.0);
    for (int row = 0; row < slits.rows; ++row) {
      const bool upper = row <= slits.upperLip;
      const double distance = (point(row, column) - point(slits.upperLip + !upper, column)).norm() / pupils.unit();
      sides[row * slits.columns + column].lips = (upper ? 1.0 : -1.0) * profile * fade(distance / regions.lipReach());
    }
  };
  const double lidRow = 0.5 * (slits.upperLid + slits.lowerLid), lidHalf = 0.5 * (slits.lowerLid - slits.upperLid);
  const auto lids = [&](int column) {
    const Eigen::Vector3d eye = point(static_cast<int>(std::lround(lidRow)), column);
    const double profile = fade(std::abs(std::abs(pupils.apply(eye).x()) - 1.0) / eyeHalfWidth);
    for (int row = 0; profile > 0.0 && pupils.apply(eye).z() > -1.2 && row < slits.rows; ++row) {
      const double distance = (point(row, column) - eye).norm() / pupils.unit();
      sides[row * slits.columns + column].lids = profile *
                                                 std::clamp((lidRow - row) / std::max(lidHalf, 0.5), -1.0, 1.0) *
                                                 fade(distance / regions.lidReach());
    }
  };
  for (int column = 0; column < slits.columns; ++column) {
    if (slits.upperLip >= 0 && column > slits.openBegin && column < slits.openEnd) lips(column);
    if (slits.upperLid >= 0.0) lids(column);
  }
  return sides;
}

}  // namespace mien
