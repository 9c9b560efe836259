#pragma once

#include <string>
#include <vector>

#include "EyePupils.h"

class vtkPointSet;

namespace mien {

/// A mesh with its 68 landmarks as vertices.
struct MeshLandmarks {
  MeshVertices vertices;
  MeshEdges edges;
  LandmarkVertices numbers{};
  EyePupils pupils;
  std::vector<bool> inEyes;  ///< of each vertex: it is an eyeball's, not the skin's

  /// From a landmark file (LandmarkTable.h) with all 68: where lips and lids part, a landmark that was placed from
  /// others may be on the wrong side. Those by place are taken to the nearest vertex, within a tenth of the distance of
  /// the outer eye corners. @return nothing, or one sentence that says what is missing or wrong
  std::string read(vtkPointSet* data, const std::string& file);
};

}  // namespace mien
