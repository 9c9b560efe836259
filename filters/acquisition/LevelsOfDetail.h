#pragma once

#include <string>
#include <vector>

#include "FaceCurves.h"
#include "FaceSurface.h"
#include "Progress.h"
#include "TriangleMesh.h"

namespace mien {

/// What is compared, and how finely it is measured.
struct DetailOptions {
  FaceSurfaceOptions surface;                                             ///< of the PDE faces
  std::vector<double> tolerances = {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0};  ///< of compact faces, mm
  double frontalThreshold = 50.0;                                         ///< only points with a larger z count, mm
  double spacing = 2.0;                                                   ///< of the points that are measured, mm
  double margin = 4.0;  ///< from the first and last curve, where the meshes end, mm
};

/// One way to keep a head, and how far it lies from the scan.
struct DetailRecord {
  std::string representation, detail;
  long long bytes = 0, triangles = 0;       ///< triangles: 0 for curves
  double rms = 0.0, maximum = 0.0;          ///< from it to the scan, mm
  double backRMS = 0.0, backMaximum = 0.0;  ///< from the scan to it, mm
  double curvesRMS = 0.0;                   ///< of the curves' points to the full curves, mm; NaN for meshes
};

/// Measures the levels of detail of a scanned head: the whole curves, their first 1 .. K / 2 modes (mode 0 alone is a
/// line), compact faces, and the part of the scan that the face covers, decimated to the same bytes, as plain and as
/// packed meshes.
/// @return nothing, or one sentence that says what is wrong; no records either when `progress` stopped it
std::string measureLevelsOfDetail(const FaceCurves& face, const TriangleMesh& scan, const DetailOptions& options,
                                  const Progress& progress, std::vector<DetailRecord>& records);

}  // namespace mien
