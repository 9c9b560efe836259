#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "Condition.h"
#include "HarmonicSplit.h"

namespace mien {

/// One solution of the PDE on an interval of u, and the rows of a grid that lie on it.
struct SurfacePiece {
  std::vector<Condition> conditions;  ///< 2m of them; `curve` counts the rows of boundaryData
  double smoothing = 1.0;             ///< a
  double begin = 0.0, end = 1.0;      ///< interval of the patch's u on which the solution is used
  std::vector<double> u;              ///< rows of the grid, inside the interval
  int firstRow = 0;                   ///< grid row of u[0]

  /// The boundary data as combinations of the curves, for part j of the split: (data x curves).
  std::function<Eigen::MatrixXd(int part)> boundaryData;
};

/// Row i is what condition i prescribes at part j of the split, as a combination of the curves: (conditions x curves).
Eigen::MatrixXd dataOfConditions(const SurfacePiece& piece, int part);

/// U_j of a piece: its 2m boundary data become grid rows. (rows x conditions)
///
/// @param derivative  order of the derivative with respect to u
/// @return an empty matrix when the conditions do not determine a surface
Eigen::MatrixXd pieceOperator(const SurfacePiece& piece, const HarmonicSplit& split, int part, int derivative);

/// [U_j D_j] of a piece: row c J + j of BoundaryField becomes grid rows. (rows x curves J), curves J as there.
///
/// @param derivative  order of the derivative with respect to u
/// @return an empty matrix when the conditions do not determine a surface
Eigen::MatrixXd surfaceOperator(const SurfacePiece& piece, const HarmonicSplit& split, int curveCount, int derivative);

/// The largest Lebesgue constant of a piece over all rates of the split.
double lebesgueConstant(const SurfacePiece& piece, const HarmonicSplit& split);

}  // namespace mien
