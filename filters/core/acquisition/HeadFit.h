#pragma once

#include <string>

#include "FaceTemplate.h"
#include "Progress.h"
#include "Similarity.h"

namespace mien {

/// How a known face was laid over a scan.
struct HeadFit {
  Similarity faceToScan;  ///< its scale holds the difference in size
  double distance =
      0.0;  ///< RMS distance (mm of the face) of the nearer four fifths of the known face to the scan after this
  double relief = 0.0;  ///< correlation, -1 .. 1, of the reliefs of known face and scan, what is smooth taken off
};

/// Lays a known face over a scan of the same unit in any pose: iterated closest points [Besl and McKay 1992,
/// Chetverikov et al. 2002: trimmed] from starts all over the rotations and two places each, the best of them refined
/// on all points.
/// @param mesh  one connected skin, in mm
/// @return nothing, or that it was stopped
std::string fitHead(const FaceTemplate& face, const TriangleMesh& mesh, HeadFit& fit, const Progress& progress = {});

}  // namespace mien
