#pragma once

#include <array>
#include <string>

#include "ViewDirection.h"

namespace mien {

/// How a face is drawn; what is drawn is a FaceState.
struct SceneStyle {
  enum class Mesh { Shaded, Wireframe, Both };

  int width = 1000, height = 1000;  ///< pixels
  int samples = 3;                  ///< computed per pixel along each side, for smooth edges
  ViewDirection view;
  Mesh mesh = Mesh::Shaded;
  bool neutralFrame = true;  ///< whether the neutral face fills the picture, for as long as the face stays within it
  std::string colorBy;       ///< name of a point or cell array; empty: the plain material
  bool curves = false;       ///< whether the boundary curves lie over the surface
  bool transparent = false;
  std::array<double, 3> background = {1.0, 1.0, 1.0};  ///< 0 .. 1
};

}  // namespace mien
