#pragma once

#include "MeshText.h"

namespace mien {

/// Whether an .stl file is text: it begins with "solid", in any letters, and has no byte 0.
bool isTextStl(std::string_view text);

/// Reads an .stl file as text ("vertex x y z", three of them in each "outer loop" .. "endloop", "endsolid" at the end,
/// in any letters) or binary (80 bytes of title, the number of triangles, 50 bytes for each; more behind them is passed
/// over); see readMeshText(). Corners at the same place become one vertex.
std::optional<MeshFault> readStlText(std::string_view text, MeshText& read);

}  // namespace mien
