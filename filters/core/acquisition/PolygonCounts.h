#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mien {

/// Of how many corners the faces of a mesh file are, before larger ones are split.
struct PolygonCounts {
  std::int64_t triangles = 0, quads = 0, larger = 0;

  std::int64_t sum() const { return triangles + quads + larger; }
};

/// @param text    the whole file
/// @param ending  ".obj", ".off" or ".ply"; of others, and of what cannot be followed, there are none
PolygonCounts countPolygons(std::string_view text, const std::string& ending);

}  // namespace mien
