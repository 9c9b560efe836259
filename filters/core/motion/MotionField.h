#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "ClosedCurves.h"
#include "TriangleMesh.h"

namespace mien {

/// Motion vectors on a surface (mm), and the surface as it is drawn under them.
struct MotionField {
  using Points = ClosedCurves::Points;

  Points origins;              ///< where the vectors start, one row each
  Points vectors;              ///< moved - origin
  Points normals;              ///< of the surface at the origins, outwards, unit; no rows: unknown
  std::vector<double> u, v;    ///< u over the whole face 0 .. 1, v in radians; empty for meshes that have none
  std::vector<long long> ids;  ///< of the points in the data set they come from
  int columns = 0;             ///< of a grid, whose rows follow each other; 0 for other meshes
  std::vector<std::array<int, 2>> patches;  ///< lowest and highest patch around each origin, 0 .. 8; empty: no patches

  TriangleMesh surface;           ///< wound outwards; may be finer than the origins
  Points surfaceNormals;          ///< of its vertices
  std::vector<Points> seams;      ///< lines between patches
  std::vector<Points> landmarks;  ///< lids, brows, nose and lips; empty for meshes that are no face

  Eigen::VectorXd magnitudes() const { return vectors.rowwise().norm(); }
};

}  // namespace mien
