#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "QuadraticMap.h"

namespace mien {

/// A facial deformation table (FDT): a quadratic map for each of the 16 regions [Obaid et al. 2009, table I].
struct DeformationTable {
  static constexpr int regionCount = 16;
  static constexpr double largestCoefficient = 100.0;  ///< either sign; files with larger ones are refused
  using Maps = std::array<QuadraticMap, regionCount>;
  using Deviations = std::array<QuadraticMap::Coefficients, regionCount>;

  Maps maps;                             ///< region r at index r - 1
  std::optional<Deviations> deviations;  ///< standard deviation of every coefficient over subjects
  double largestDisplacement = 0.0;      ///< of the points it was fitted to, pupil units; 0: not known

  /// What no file may hold, a coefficient, deviation or displacement beyond the limit, in one sentence; or nothing.
  std::string describeExcess() const;

  /// Between this table (0) and another (1), coefficient by coefficient; beyond 0 .. 1 it extrapolates. No deviations.
  DeformationTable blended(const DeformationTable& other, double fraction) const;

  /// The sum of displacements of several tables, each times its weight: identity + sum w (table - identity). One table
  /// of weight 1 stays what it is, with its deviations; else there are none.
  static DeformationTable weighted(const std::vector<std::pair<DeformationTable, double>>& tables);
};

}  // namespace mien
