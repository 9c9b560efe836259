#pragma once

#include <array>
#include <string>
#include <vector>

#include "FacialRegions.h"
#include "MarkerTable.h"
#include "QuadraticFit.h"

namespace mien {

/// Points of one face before and after in pupil units, and the region each belongs to (1 .. 16).
struct TableSamples {
  PlanePoints before, after;
  std::vector<int> regions;
};

/// The samples of a recording. The region of a marker is the file's, else that of its place; of the 68 landmarks of
/// Multi-PIE 49-53 and 61-63 belong to the upper lip, 55-59 and 65-67 to the lower, 37, 38, 43, 44 to the upper lids
/// and 40, 41, 46, 47 to the lower.
TableSamples samplesOf(const MarkerTable& markers, const FacialRegions& regions);

/// What a fit asks of its points.
struct FitOptions {
  bool strict = false;  ///< refuse regions with fewer than six independent points
  bool allowEmpty =
      false;  ///< leave regions without points unknown (the identity), as of the 68 landmarks the forehead's
};

/// A table fitted to one recording.
struct TableFit {
  DeformationTable table;
  std::array<QuadraticFit, FacialRegions::count> regions;
  double rms = 0.0;    ///< over all points, pupil units
  double noise = 0.0;  ///< standard deviation of a coordinate about the maps, pupil units

  std::vector<int> sparseRegions() const;  ///< regions with points, but fewer than six independent ones
  std::vector<int> emptyRegions() const;   ///< regions without points
  std::string warning() const;             ///< one sentence that names the empty and the sparse regions, or nothing

  /// @return nothing, or one sentence that names the regions without points, (strict) the sparse ones, or a
  /// map or movement that no face reaches
  std::string fit(const TableSamples& samples, const FitOptions& options = {});
};

}  // namespace mien
