#pragma once

#include "MienAcquisitionModule.h"

#include <string>
#include <vector>

/// What `mien acquire` does.
namespace mien {

struct AcquireOptions {
  std::vector<std::string> scans;  ///< .ply, .obj, .stl, .off; one, or several with `mean`
  std::string landmarkFile;        ///< CSV, see LandmarkTable.h; serves all scans
  std::string outputFile;          ///< .vtp
  bool mean = false;               ///< the symmetric mean of all scans instead of one scan as it is
  int pointsPerCurve = 40;         ///< even, 8 .. 4096
};

/// Reads the scans, measures their boundary curves and writes them as XML polydata (inline, not compressed).
/// @return nothing, or "FILE[:LINE]: what is wrong and what to do"; no file is written then
MIENACQUISITION_EXPORT std::string acquire(const AcquireOptions& options);

}  // namespace mien
