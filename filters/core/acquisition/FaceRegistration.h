#pragma once

#include <string>

#include "FaceTemplate.h"
#include "Progress.h"
#include "Similarity.h"

namespace mien {

/// A known face bent onto a scan.
struct FaceRegistration {
  TriangleMesh::Vertices points;  ///< of the grid of the template, on the scan (mm, frame of the scan)
  double distance = 0.0;          ///< RMS of what is left, mm, over points that found skin
  double covered = 0.0;           ///< share of the points that found skin, 0 .. 1
};

/// Bends a face that lies over a scan onto it, smoothly as a whole, then stiffly, then more softly: non-rigid iterated
/// closest points on a grid, with the Laplacian of the displacement as stiffness [Amberg, Romdhani and Vetter 2007].
/// @return nothing, or that it was stopped
std::string registerFace(const FaceTemplate& face, const Similarity& faceToScan, const TriangleMesh& mesh,
                         FaceRegistration& registration, const Progress& progress = {});

}  // namespace mien
