#pragma once

#include "FacialRegions.h"
#include "MarkerTable.h"
#include "QuadraticFit.h"

#include <array>
#include <string>
#include <vector>

namespace mien {

/// Points of one face before and after in pupil units, and the region each belongs to (1 .. 16).
struct TableSamples {
  PlanePoints before, after;
  std::vector<int> regions;
};

/// The samples of a recording. The region of a marker is the file's, else that of its place; landmarks 49-53 and 61-63 of
/// the 68 of Multi-PIE belong to the upper lip and 55-59 and 65-67 to the lower.
TableSamples samplesOf(const MarkerTable& markers, const FacialRegions& regions);

/// A table fitted to one recording.
struct TableFit {
  DeformationTable table;
  std::array<QuadraticFit, FacialRegions::count> regions;
  double rms = 0.0;                   ///< over all points, pupil units
  std::vector<int> sparseRegions() const;  ///< regions with fewer than six independent points

  /// @return nothing, or one sentence that names the regions without points, or (strict) the sparse ones
  std::string fit(const TableSamples& samples, bool strict = false);
};

}  // namespace mien
