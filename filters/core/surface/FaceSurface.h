#pragma once

#include <array>
#include <string>
#include <vector>

#include "FaceLayout.h"
#include "FaceScheme.h"
#include "RowLayout.h"
#include "SurfacePiece.h"

namespace mien {

/// What decides the shape of a PDE face between its curves.
struct FaceSurfaceOptions {
  static constexpr double largestSmoothing = 1000.0;
  static constexpr double largestStrength = 1000.0;  ///< either sign

  std::string scheme = "spline";
  std::array<double, FaceLayout::patchCount> smoothing = {1, 1, 1, 1, 1, 1, 1, 1, 1};  ///< a of each patch
  int modes = 5;                                                                       ///< N
  bool remainder = true;
  double derivativeStrength = 1.0;  ///< factor on shared derivatives [S 3.3], -1000 .. 1000

  bool operator==(const FaceSurfaceOptions& other) const;
};

/// One sentence that says which option is out of range for curves of K points and what is allowed, or nothing.
std::string describeFault(const FaceSurfaceOptions& options, int pointsPerCurve);

/// The pieces of a face, patch by patch, with the rows of a grid dealt to them.
std::vector<SurfacePiece> facePieces(const FaceSurfaceOptions& options, const RowLayout& layout);

}  // namespace mien
