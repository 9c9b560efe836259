#pragma once

#include <functional>
#include <vector>

#include "TriangleMesh.h"

namespace mien {

/// Points spread over triangles, for measures that must not depend on how a surface is cut into them.
///
/// Every triangle is cut into n x n equal ones with edges no longer than the spacing; the middle of each stands for its
/// area. The corners of the mesh come along with no area, so that a largest distance misses none of them.
struct SurfaceSamples {
  std::vector<Eigen::Vector3d> points;  ///< mm
  std::vector<double> areas;            ///< mm2

  /// @param counts  which points are taken
  SurfaceSamples(const TriangleMesh& mesh, double spacing, const std::function<bool(const Eigen::Vector3d&)>& counts);
};

}  // namespace mien
