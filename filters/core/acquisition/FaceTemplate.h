#pragma once

#include <array>

#include "FaceCurves.h"
#include "FaceLandmarks.h"
#include "TriangleMesh.h"

namespace mien {

/// The front of a known face as a grid of points, with its 68 landmarks bound to it: what is laid over a scan to find
/// the landmarks there.
struct FaceTemplate {
  /// A point given by three points of the grid and what is left to them.
  struct Place {
    std::array<int, 3> corners{};
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< mm
  };

  int rows = 0, columns = 0;
  TriangleMesh mesh;               ///< rows x columns points, row by row from the forehead; mm
  TriangleMesh::Vertices normals;  ///< outwards
  FaceLandmarks landmarks;
  std::array<Place, FaceLandmarks::count> places{};

  int index(int row, int column) const { return row * columns + column; }

  /// The landmarks when the points of the grid lie elsewhere.
  FaceLandmarks landmarksOn(const TriangleMesh::Vertices& points) const;
};

/// Samples the spline surface (a = 1, N = 5) of a face in front of its ears.
FaceTemplate makeFaceTemplate(const FaceCurves& face, const FaceLandmarks& landmarks);

}  // namespace mien
