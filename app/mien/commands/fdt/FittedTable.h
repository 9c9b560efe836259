#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "DeformationTable.h"
#include "FacialRegions.h"
#include "MarkerFileOptions.h"

class vtkPointSet;

namespace mien {

/// A table fitted to markers or surfaces, and how well.
struct FittedTable {
  struct Region {
    int points = 0;
    double rms = 0.0;  ///< pupil units
  };
  DeformationTable table;
  std::array<Region, FacialRegions::count> regions;
  double rms = 0.0;                   ///< over all points, pupil units
  std::string warning;                ///< names the empty and sparse regions, or is empty
  std::vector<std::string> suspects;  ///< markers that move otherwise than those around them, worst first
  std::vector<std::string> missing;   ///< markers that were not seen in both states

  /// rms, regions[] {region, name, points, a[6], b[6], rms}, and warning, suspects and missing where there are any.
  nlohmann::ordered_json description(const FacialRegions& map) const;

  /// A row for each region: its points, rms and the displacement of its centre.
  nlohmann::ordered_json rows(const FacialRegions& map) const;
};

/// Fits a table to a recording; what is wrong is a FileFailure that names `file`. Sparse regions and
/// those without a point, which stay the identity with a warning, are one with `strict`.
FittedTable fitMarkers(const MarkerTable& markers, const FacialRegions& regions, bool strict, const std::string& file);

/// Fits a table to a surface before and after: as many points in the same order (vtkFDTFitFilter).
///
/// @param landmarkFile  68 landmarks, or empty
/// @param names         of the surfaces, for errors
FittedTable fitSurfaces(vtkPointSet* neutral, vtkPointSet* expression, const MarkerFileOptions& options,
                        const std::string& landmarkFile, bool strict, const std::string& names);

}  // namespace mien
