#pragma once

#include <cstddef>

#include "TriangleMesh.h"

namespace mien {

/// Bytes of a mesh as it is usually kept: three single precision numbers per vertex, three indices per triangle of 16
/// bits, or 32 where there are more than 65,536 vertices.
std::size_t plainMeshSize(const TriangleMesh& mesh);

/// The mesh with its coordinates rounded to multiples of a step, mm.
TriangleMesh roundedMesh(const TriangleMesh& mesh, double step);

/// Bytes of a rounded mesh without what one triangle tells of the next: triangles are walked from edge to edge, a new
/// vertex is the difference from the parallelogram beside it [Touma and Gotsman 1998], an old one its age; then LZMA as
/// for a compact face. An upper bound of what mesh coders reach.
std::size_t packedMeshSize(const TriangleMesh& mesh, double step);

}  // namespace mien
