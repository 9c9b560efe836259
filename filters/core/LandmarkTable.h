#pragma once

#include "FaceLandmarks.h"
#include "TriangleMesh.h"

#include <array>
#include <string>

namespace mien {

/// The 68 landmarks as a file gives them: by vertex number, by position, or by both.
///
/// CSV with a header line naming the columns `landmark` (0 .. 67) and `vertex` (from 0), or `landmark`, `x`, `y`, `z` (mm), or all
/// of them, in any order. With a vertex column, positions come from the mesh, so that one file serves every mesh of its topology.
struct LandmarkTable {
  bool hasVertices = false;
  std::array<long, FaceLandmarks::count> vertices{};
  FaceLandmarks positions;  ///< zero when the file has vertices only
};

/// Parses the text of a landmark file.
/// @return nothing, or "LINE: what is wrong and what to do"
std::string parseLandmarks(const std::string& text, LandmarkTable& table);

/// The landmarks on a mesh.
/// @return nothing, or one sentence that names the landmark whose vertex the mesh does not have
std::string placeLandmarks(const LandmarkTable& table, const TriangleMesh& mesh, FaceLandmarks& landmarks);

}  // namespace mien
