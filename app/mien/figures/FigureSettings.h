#pragma once

#include <string>
#include <vector>

#include "FigureTheme.h"

namespace mien {

/// What was asked of a figure beside the face.
struct FigureSettings {
  double width = 170.0;        ///< mm
  double dotsPerInch = 300.0;  ///< of pictures in it
  FigureTheme theme;
  bool labelled = true;        ///< (a), (b) .. before panels
  bool captioned = true;       ///< title, caption and provenance in the picture, not only in its metadata
  bool hasResolution = false;  ///< whether the face's resolution was asked for, for figures that have one of their own
  std::string frames;          ///< of the animation, as frameIndices() reads them; empty: the figure's own choice
  std::vector<std::string> textures;  ///< image files; empty: the texture that comes with Mien
};

}  // namespace mien
