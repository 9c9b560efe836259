#pragma once

#include <algorithm>
#include <vector>

#include "AlignedRows.h"
#include "BoundaryCoefficients.h"
#include "SurfaceRows.h"

namespace mien {

/// B_j(v): boundary data split into harmonics and sampled at the columns of a grid [S eq. 9-11], strip by strip.
///
/// Row j D + d is part j of datum d (of D): the x of a strip's columns, then y, then z (mm, or mm per radian for the
/// derivative), each padded to whole vectors.
template <class Scalar>
class BoundaryField {
 public:
  /// @param v           the columns, radians
  /// @param derivative  0: the data, 1: d/dv, 2: d2/dv2
  BoundaryField(const HarmonicSplit& split, const Eigen::VectorXd& v, int derivative);

  int stripCount() const { return (columns_ + columnsOfStrip - 1) / columnsOfStrip; }
  int columnsOf(int strip) const { return std::min(columns_ - strip * columnsOfStrip, columnsOfStrip); }

  /// Room for B at the columns of one strip; nothing happens where there is some.
  void makeRoom(int dataCount, AlignedRows<Scalar>& b) const;

  /// Samples some of `dataCount` data at the columns of a strip. No allocation.
  /// @param coefficients  in BoundaryCoefficients' order
  void sample(const Scalar* coefficients, int dataCount, const DataRange& data, int strip,
              AlignedRows<Scalar>& b) const;

 private:
  HarmonicSplit split_;
  int columns_;
  std::vector<AlignedRows<Scalar>> synthesis_;  ///< by part: coefficients x columns
};

extern template class BoundaryField<float>;
extern template class BoundaryField<double>;

}  // namespace mien
