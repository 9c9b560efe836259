#pragma once

#include "SurfaceJet.h"

namespace mien {

/// Curvatures at a point of a surface, from the first and second fundamental forms.
///
/// A normal curvature is positive where the surface bends away from the outward normal S_u x S_v: on a sphere of radius
/// R seen from outside both principal curvatures and the mean curvature are +1 / R, the Gaussian curvature is 1 / R^2.
/// All are NaN where the surface has no tangent plane.
struct SurfaceCurvature {
  double gaussian = 0.0;  ///< 1/mm^2, the product of the principal curvatures
  double mean = 0.0;      ///< 1/mm, half their sum
  double maximum = 0.0;   ///< 1/mm, the larger principal curvature
  double minimum = 0.0;   ///< 1/mm, the smaller

  explicit SurfaceCurvature(const SurfaceJet& jet);
};

/// The outward unit normal, or NaN where the surface has no tangent plane.
Eigen::Vector3d unitNormal(const SurfaceJet& jet);

/// The normal curvature (1/mm, signed as above) in the tangent direction perpendicular to the curve u = constant.
double curvatureAcross(const SurfaceJet& jet);

}  // namespace mien
