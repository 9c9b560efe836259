#pragma once

#include <string>

#include "FaceSurface.h"

/// A scheme with one a for all patches.
inline mien::FaceSurfaceOptions optionsFor(const std::string& scheme, double a = 1.0) {
  mien::FaceSurfaceOptions options;
  options.scheme = scheme;
  options.smoothing.fill(a);
  return options;
}
