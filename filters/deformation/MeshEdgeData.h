#pragma once

#include <string>
#include <vector>

#include "FaceSides.h"
#include "vtkType.h"

class vtkPoints;
class vtkPointSet;

namespace mien {

/// The edges of the visible cells (polygons, triangles, quads, lines). @return nothing, or which cell names a point
/// that is not there
std::string readEdges(vtkPointSet* data, MeshEdges& edges);

/// Whether any visible cell is a polygon.
bool hasPolygons(vtkPointSet* data);

/// The visible polygons of a mesh, kept to compute normals again when the points have moved.
class MeshPolygons {
 public:
  MeshPolygons() = default;

  /// None when there are no polygons, or one of them names a point that is not there.
  explicit MeshPolygons(vtkPointSet* data);

  bool empty() const { return starts_.size() < 2; }

  /// Unit normals at the points, of the polygons around each by area, outwards as a whole: away from the middle of the
  /// points, whatever the polygons' winding and wherever the mesh is, open or closed; 0 for a point without polygons.
  /// Empty without polygons.
  std::vector<Eigen::Vector3d> normals(vtkPoints* points) const;

 private:
  std::vector<vtkIdType> starts_, corners_;  // of polygon i: starts_[i] .. starts_[i + 1] - 1
};

}  // namespace mien
