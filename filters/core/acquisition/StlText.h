#pragma once

#include "MeshText.h"

namespace mien {

/// Reads an .stl file, binary (80 bytes of title, the number of triangles, 50 bytes for each; more behind them is
/// passed over) or text ("vertex x y z", three of them in each "outer loop" .. "endloop", "endsolid" at the end, in any
/// letters; what stands before the first facet, behind endsolid, and bytes 0 at the end are passed over); see
/// readMeshText(). Binary is what holds the triangles it promises, whatever its title; text what has facets and
/// vertices. Corners at the same place become one vertex.
std::optional<MeshFault> readStlText(std::string_view text, MeshText& read);

}  // namespace mien
