#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "HarmonicSplit.h"
#include "SurfacePiece.h"

namespace mien {

/// The boundary data of all pieces of a surface, each once: curves as they are, and derivatives that follow from them.
///
/// A spline's slope at a curve takes part in two pieces and depends on all curves; made once, it is one datum of
/// either piece, and a row of U has 2m numbers per harmonic instead of one for every curve.
class BoundaryData {
 public:
  BoundaryData(const HarmonicSplit& split, int curveCount);

  /// The positions of a piece's data, condition by condition.
  std::vector<int> add(const SurfacePiece& piece);

  int count() const { return static_cast<int>(curve_.size()); }

  /// Fourier coefficients of the data (K x 3 data) from those of the curves (K x 3 curves).
  /// No allocation after the first time.
  void derive(const Eigen::MatrixXd& curves, Eigen::MatrixXd& data);

 private:
  using Datum = std::vector<Eigen::RowVectorXd>;  ///< by part, the combination of the curves
  using Combinations = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  int position(const Datum& datum);
  void combine(const Datum& datum);

  HarmonicSplit split_;
  int curveCount_;
  std::vector<int> curve_;                  ///< by datum: the curve that it is in every part, or -1
  std::vector<Combinations> combinations_;  ///< by part: the data that are no curves, (data x curves)
  Combinations rows_, derived_;
  std::map<std::vector<double>, int> known_;
};

}  // namespace mien
