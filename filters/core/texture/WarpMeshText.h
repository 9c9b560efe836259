#pragma once

#include <string>

#include "WarpMesh.h"

namespace mien {

/// Text form of a warp mesh, a .csv file:
///
///     mien_warp_mesh,1,WIDTH,HEIGHT          version 1; size of the image in pixels
///     row,column,x,y,name                    columns in any order, name may be left out
///     1,1,0,0,
///     1,2,170.5,0,
///
/// then a line for every point, in any order; rows and columns count from 1. Lines that begin with # are comments.
/// x and y are pixels from the image's upper left corner, y down.
constexpr int warpMeshVersion = 1;

/// @return nothing, or "LINE: what is wrong and what to do"; the mesh is then as it was. A folded mesh is a fault.
std::string parseWarpMesh(const std::string& text, WarpMesh& mesh);

/// The text that parseWarpMesh reads back without a difference.
std::string writeWarpMesh(const WarpMesh& mesh);

}  // namespace mien
