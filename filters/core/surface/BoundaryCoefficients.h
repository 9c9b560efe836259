#pragma once

#include <Eigen/Core>
#include <vector>

#include "AlignedRows.h"
#include "ClosedCurves.h"
#include "HarmonicSplit.h"

namespace mien {

template <class Scalar>
using RowMajor = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Boundary data first .. end - 1.
struct DataRange {
  int first, end;

  int count() const { return end - first; }
};

/// Fourier coefficients of boundary data, part by part of a split: what a part needs lies together.
///
/// The first data are the curves themselves. Of part j there are 3 rows a datum, x, y, z, and coefficientCount(j)
/// columns (mm).
class BoundaryCoefficients {
 public:
  BoundaryCoefficients(const HarmonicSplit& split, int curveCount, int dataCount);

  int curveCount() const { return curveCount_; }
  int dataCount() const { return dataCount_; }

  /// The rows of part j, contiguous; rowProductPadding numbers behind them can be read.
  double* part(int part) { return values_.data() + firstValue(part); }

  const Eigen::ArrayXd& values() const { return values_; }  ///< part by part

  /// Samples of the curves into coefficients, of those alone that are not what they were; no allocation.
  /// @return which curves changed: all of them the first time
  const std::vector<DataRange>& setCurves(const ClosedCurves& curves);

 private:
  void takeSamples(const ClosedCurves& curves);
  void analyse(const DataRange& changed);
  long firstValue(int part) const { return 3L * dataCount_ * split_.firstCoefficient(part); }

  HarmonicSplit split_;
  int curveCount_, dataCount_;
  AlignedRows<double> analysis_;  ///< samples x coefficients
  RowMajor<double> samples_;      ///< 3 curves x samples
  RowMajor<double> ofCurves_;     ///< 3 curves x coefficients
  Eigen::ArrayXd values_;
  std::vector<DataRange> changed_;
};

/// K x 3 curves: Fourier coefficients of every coordinate of every curve. No allocation after the first time.
void fourierCoefficients(const Eigen::MatrixXd& analysis, const ClosedCurves& curves, Eigen::MatrixXd& samples,
                         Eigen::MatrixXd& coefficients);

}  // namespace mien
