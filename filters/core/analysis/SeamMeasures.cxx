#include "SeamMeasures.h"

#include <Eigen/Geometry>
#include <cmath>

#include "SurfaceCurvature.h"

namespace mien {

namespace {

/// The arc cosine would lose half the digits near 0, where the angles of smooth seams lie.
double angleInDegrees(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * (180.0 / M_PI);
}

double relativeJump(const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
  const double mean = 0.5 * (before.norm() + after.norm());
  return mean == 0.0 ? 0.0 : (before - after).norm() / mean;
}

}  // namespace

SeamMeasures::SeamMeasures(const SurfaceJet& before, const SurfaceJet& after)
    : g0((before.s - after.s).norm()),
      g1(angleInDegrees(unitNormal(before), unitNormal(after))),
      c1(relativeJump(before.su, after.su)),
      g2(std::abs(curvatureAcross(before) - curvatureAcross(after))),
      c2(relativeJump(before.suu, after.suu)) {}

}  // namespace mien
