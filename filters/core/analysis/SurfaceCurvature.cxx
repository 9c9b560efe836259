#include "SurfaceCurvature.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace mien {

namespace {

/// The second fundamental form in an orthonormal frame of the tangent plane whose first axis is S_v.
struct CurvatureMatrix {
  double along, mixed, across;
};

/// With S_u = q t + r d in the frame (t along S_v, d across), d = (S_u - c S_v) / r and c = q / |S_v|.
CurvatureMatrix curvatureMatrix(const SurfaceJet& jet) {
  const Eigen::Vector3d normal = unitNormal(jet);
  const double uu = -jet.suu.dot(normal), uv = -jet.suv.dot(normal), vv = -jet.svv.dot(normal);
  const double p = jet.sv.norm();
  const double c = jet.su.dot(jet.sv) / (p * p);
  const double r = (jet.su - c * jet.sv).norm();
  return {vv / (p * p), (uv - c * vv) / (p * r), (uu - 2.0 * c * uv + c * c * vv) / (r * r)};
}

}  // namespace

Eigen::Vector3d unitNormal(const SurfaceJet& jet) {
  const Eigen::Vector3d normal = jet.su.cross(jet.sv);
  const double length = normal.norm();
  // below this the direction of the product is rounding
  const double noise = 4.0 * std::numeric_limits<double>::epsilon() * jet.su.norm() * jet.sv.norm();
  if (!(length > noise)) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return normal / length;
}

double curvatureAcross(const SurfaceJet& jet) {
  return curvatureMatrix(jet).across;
}

// The root of H^2 - K would lose half the digits where both principal curvatures are equal; this form does not.
SurfaceCurvature::SurfaceCurvature(const SurfaceJet& jet) {
  const CurvatureMatrix matrix = curvatureMatrix(jet);
  const double spread = std::hypot(0.5 * (matrix.along - matrix.across), matrix.mixed);
  gaussian = matrix.along * matrix.across - matrix.mixed * matrix.mixed;
  mean = 0.5 * (matrix.along + matrix.across);
  maximum = mean + spread;
  minimum = mean - spread;
}

}  // namespace mien
