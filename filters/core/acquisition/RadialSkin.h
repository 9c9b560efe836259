#pragma once

#include <array>
#include <string>
#include <vector>

#include "HeadAxis.h"
#include "TriangleMesh.h"

namespace mien {

/// Where horizontal rays from a vertical axis leave a triangle mesh for the last time.
///
/// Triangles are sorted into bins of one degree of azimuth, so that a ray looks at a few hundred of them.
class RadialSkin {
 public:
  /// Keeps a reference to the mesh, whose indices must be valid (see describeFault).
  RadialSkin(const TriangleMesh& mesh, const HeadAxis& axis);

  const HeadAxis& axis() const { return axis_; }

  /// Radius (mm) of the outermost hit of the ray at height y (mm) and azimuth (radians), NaN without a hit.
  double radius(double azimuth, double y) const;

  /// As radius(); in a hole of up to 36 mm across, the radius of a quadratic surface through the skin around it.
  double filledRadius(double azimuth, double y) const;

 private:
  static constexpr int binCount = 360;
  void fileTriangle(int triangle);

  const TriangleMesh& mesh_;
  HeadAxis axis_;
  std::array<std::vector<int>, binCount> bins_;
};

/// One sentence that says what makes the mesh unusable (no triangles, indices out of range, not finite), or nothing.
std::string describeFault(const TriangleMesh& mesh);

}  // namespace mien
