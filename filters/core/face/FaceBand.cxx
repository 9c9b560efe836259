#include "FaceBand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "FaceLayout.h"

namespace mien {

namespace {

HeadAxis middleOf(const ClosedCurves& curves) {
  const Eigen::RowVector3d low = curves.points.colwise().minCoeff(), high = curves.points.colwise().maxCoeff();
  return {0.5 * (low.x() + high.x()), 0.5 * (low.z() + high.z())};
}

}  // namespace

FaceBand::FaceBand(const ClosedCurves& curves)
    : axis_(middleOf(curves)), top_(edgeOf(curves, 0)), bottom_(edgeOf(curves, FaceLayout::curveCount - 1)) {}

FaceBand::Edge FaceBand::edgeOf(const ClosedCurves& curves, int curve) const {
  std::vector<std::pair<double, double>> points;
  for (int j = 0; j < curves.pointsPerCurve; ++j) {
    const Eigen::Vector3d point = curves.curve(curve).row(j);
    for (const double turn : {-2.0 * M_PI, 0.0, 2.0 * M_PI})
      points.emplace_back(axis_.azimuth(point) + turn, point.y());
  }
  std::sort(points.begin(), points.end());
  Edge edge;
  for (const auto& [azimuth, height] : points) {
    edge.azimuths.push_back(azimuth);
    edge.heights.push_back(height);
  }
  return edge;
}

double FaceBand::Edge::heightAt(double azimuth) const {
  const auto next = std::upper_bound(azimuths.begin(), azimuths.end(), azimuth) - azimuths.begin();
  if (next == 0 || next == static_cast<std::ptrdiff_t>(azimuths.size())) return heights[next == 0 ? 0 : next - 1];
  const double share = (azimuth - azimuths[next - 1]) / (azimuths[next] - azimuths[next - 1]);
  return heights[next - 1] + share * (heights[next] - heights[next - 1]);
}

bool FaceBand::contains(const Eigen::Vector3d& point, double margin) const {
  const double azimuth = axis_.azimuth(point);
  return point.y() < top_.heightAt(azimuth) - margin && point.y() > bottom_.heightAt(azimuth) + margin;
}

}  // namespace mien
