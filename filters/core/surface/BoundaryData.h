#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "BoundaryCoefficients.h"
#include "SurfacePiece.h"

namespace mien {

/// The boundary data of all pieces of a surface, each once: the curves as they are, then derivatives that follow from
/// them.
///
/// A spline's slope at a curve takes part in two pieces and depends on all curves; made once, it is one datum of
/// either piece, and a row of U has 2m numbers per harmonic instead of one for every curve.
class BoundaryData {
 public:
  BoundaryData(const HarmonicSplit& split, int curveCount);

  /// The positions of a piece's data, condition by condition.
  std::vector<int> add(const SurfacePiece& piece);

  int curveCount() const { return curveCount_; }
  int count() const { return curveCount_ + static_cast<int>(combinations_.front().rows()); }

  /// The curves that datum curveCount() + i follows from.
  const std::vector<int>& sources(int i) const { return sources_[i]; }

  /// The coefficients of what follows from the curves, from theirs. No allocation.
  void derive(BoundaryCoefficients& coefficients) const;

 private:
  using Datum = std::vector<Eigen::RowVectorXd>;  ///< by part, the combination of the curves

  int position(const Datum& datum);
  void combine(const Datum& datum);

  HarmonicSplit split_;
  int curveCount_;
  std::vector<RowMajor<double>> combinations_;  ///< by part: the data that are no curves, (data x curves)
  std::vector<std::vector<int>> sources_;
  std::map<std::vector<double>, int> known_;
};

}  // namespace mien
