#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "TriangleMesh.h"

namespace mien {

/// Of how many corners the faces of a mesh file are, before larger ones are split.
struct PolygonCounts {
  std::int64_t triangles = 0, quads = 0, larger = 0;

  std::int64_t sum() const { return triangles + quads + larger; }
};

/// What a mesh file holds: its vertices in their order (of .stl one for each place), and its faces as triangles.
struct MeshText {
  TriangleMesh mesh;
  PolygonCounts polygons;
};

/// Why a mesh file cannot be read.
struct MeshFault {
  std::int64_t line = 0;  ///< from 1; 0 in binary files
  std::string message;
};

/// Reads a mesh: .ply as text or binary, with faces or triangle strips, before or behind the vertices; .off as text
/// or binary of either byte order (ST, C and N before OFF too); .obj, whose vertices and faces may go on behind a
/// backslash; .stl as text or binary. A byte order mark and blanks may stand before any text.
/// Faces of more than three corners are split around their first one, triangles with a corner twice are left out.
/// Refused: vertices that are no finite numbers, faces with a corner that the mesh does not have, counts that are not
/// kept, text that is cut off. Memory follows what is in the file, not what it promises.
///
/// @param text    the whole file
/// @param ending  ".obj", ".off", ".ply" or ".stl"
/// @return the fault, and then `read` is as it was; or nothing
std::optional<MeshFault> readMeshText(std::string_view text, const std::string& ending, MeshText& read);

constexpr const char* exportMeshAgain = "; the file is damaged, export the scan again";

}  // namespace mien
