#pragma once

#include <vector>

#include "AlignedRows.h"
#include "BoundaryCoefficients.h"
#include "SurfaceRows.h"

namespace mien {

/// B_j(v): boundary data split into harmonics and sampled at the columns of a grid [S eq. 9-11].
///
/// Row j D + d is part j of datum d (of D): the x of all columns, then y, then z (mm, or mm per radian for the
/// derivative), each padded to whole vectors.
template <class Scalar>
class BoundaryField {
 public:
  /// @param v           the columns, radians
  /// @param derivative  0: the data, 1: d/dv, 2: d2/dv2
  BoundaryField(const HarmonicSplit& split, const Eigen::VectorXd& v, int derivative);

  /// Takes the coefficients of `dataCount` data, in BoundaryCoefficients' order. No allocation after the first time.
  void update(const Scalar* coefficients, int dataCount);

  BoundaryPlanes<Scalar> planes() const { return {matrix_.row(0), matrix_.stride(), columns_}; }

 private:
  HarmonicSplit split_;
  int columns_;
  std::vector<AlignedRows<Scalar>> synthesis_;  ///< by part: coefficients x columns
  AlignedRows<Scalar> matrix_;                  ///< 3 D parts x columns
};

extern template class BoundaryField<float>;
extern template class BoundaryField<double>;

}  // namespace mien
