#pragma once

#include <Eigen/Core>
#include <vector>

#include "ClosedCurves.h"
#include "HarmonicSplit.h"

namespace mien {

template <class Scalar>
using RowMajor = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// B_j(v): closed curves split into harmonics and sampled at the columns of a grid [S eq. 9-11].
///
/// Row c J + j of the matrix is part j of curve or datum c (J parts); its columns are x, y, z of column 0, then
/// of column 1, and so on (mm, or mm per radian for the derivative), padded with zeros for rowProduct().
template <class Scalar>
class BoundaryField {
 public:
  /// @param v           the columns, radians
  /// @param derivative  0: the curves, 1: d/dv, 2: d2/dv2
  BoundaryField(const HarmonicSplit& split, const Eigen::VectorXd& v, int derivative);

  /// Takes the Fourier coefficients of curves, as fourierCoefficients() gives them. No allocation after the first time.
  void update(const Eigen::MatrixXd& coefficients);

  const RowMajor<Scalar>& matrix() const { return matrix_; }
  int partCount() const { return split_.count(); }

 private:
  void fillPart(int part, int curveCount);

  HarmonicSplit split_;
  std::vector<RowMajor<double>> synthesis_;  ///< by part: columns x coefficients
  RowMajor<double> coefficients_;            ///< K x 3 curves, padded for rowProduct()
  RowMajor<double> sampled_;                 ///< columns x 3 curves, of one part
  RowMajor<Scalar> matrix_;
};

/// K x 3 curves: Fourier coefficients of every coordinate of every curve. No allocation after the first time.
void fourierCoefficients(const Eigen::MatrixXd& analysis, const ClosedCurves& curves, Eigen::MatrixXd& samples,
                         Eigen::MatrixXd& coefficients);

extern template class BoundaryField<float>;
extern template class BoundaryField<double>;

}  // namespace mien
