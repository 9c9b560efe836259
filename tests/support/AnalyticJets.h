#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "SurfaceJet.h"

/// Jets of surfaces of revolution about y, u running down and v around as on a face, so that S_u x S_v points outwards.
/// `radius` and `height` are the profile with its first two derivatives with respect to u.
inline mien::SurfaceJet revolutionJet(const Eigen::Vector3d& radius, const Eigen::Vector3d& height, double v) {
  const Eigen::Vector3d out(-std::sin(v), 0.0, -std::cos(v)), along(-std::cos(v), 0.0, std::sin(v));
  mien::SurfaceJet jet;
  jet.s = radius[0] * out + height[0] * Eigen::Vector3d::UnitY();
  jet.su = radius[1] * out + height[1] * Eigen::Vector3d::UnitY();
  jet.sv = radius[0] * along;
  jet.suu = radius[2] * out + height[2] * Eigen::Vector3d::UnitY();
  jet.suv = radius[1] * along;
  jet.svv = -radius[0] * out;
  return jet;
}

/// A circle in the profile: at u its angle from the upward axis is `angle`, growing by `speed` radians per u. With
/// `axisDistance` 0 the surface is a sphere, else a torus.
inline mien::SurfaceJet circleJet(double axisDistance, double circle, double centreHeight, double angle, double speed,
                                  double v) {
  const double c = std::cos(angle), s = std::sin(angle);
  return revolutionJet({axisDistance + circle * s, circle * speed * c, -circle * speed * speed * s},
                       {centreHeight + circle * c, -circle * speed * s, -circle * speed * speed * c}, v);
}

inline mien::SurfaceJet sphereJet(double radius, double centreHeight, double angle, double speed, double v) {
  return circleJet(0.0, radius, centreHeight, angle, speed, v);
}

/// The same surface with parameters (u, v + shear u): no measure of the surface's shape may change.
inline mien::SurfaceJet sheared(const mien::SurfaceJet& jet, double shear) {
  mien::SurfaceJet result = jet;
  result.su = jet.su + shear * jet.sv;
  result.suu = jet.suu + 2.0 * shear * jet.suv + shear * shear * jet.svv;
  result.suv = jet.suv + shear * jet.svv;
  return result;
}
