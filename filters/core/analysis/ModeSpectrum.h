#pragma once

#include <functional>
#include <string>
#include <vector>

#include "BoundaryCoefficients.h"
#include "FaceSurface.h"

namespace mien {

/// What one part of the split, a Fourier mode or the remainder, adds to a surface.
///
/// RMS values are over (u, v): exact in v by Parseval's theorem, trapezoidal in the u of the whole face over the
/// rows, every patch one ninth; not weighted by area. Mode 0 is measured from the surface's centroid (the mean over u
/// and v), or the origin would decide.
struct ModeMeasures {
  std::string mode;              ///< "0", "1", ... or "remainder"
  double rms = 0.0;              ///< mm
  double max = 0.0;              ///< mm, over the points of the grid
  double energyShare = 0.0;      ///< rms^2 over the sum of all; they sum to 1
  double cumulativeError = 0.0;  ///< mm, RMS of what is missing from the surface when parts up to this one are summed
};

/// The contributions S_j(u, v) = U_j(u) B_j(v) of all parts to a PDE face: they sum to the face's surface [S eq. 9-11].
///
/// The sum of modes 0 .. n is also the surface that n modes without a remainder make.
class ModeSpectrum {
 public:
  /// Makes the operators, which stay good for all curves of K points.
  /// @param layout  rows of the grid
  /// @param v       columns of the grid, radians
  ModeSpectrum(const FaceSurfaceOptions& options, const RowLayout& layout, int pointsPerCurve,
               const Eigen::VectorXd& v);

  /// One sentence when the scheme's conditions determine no surface, or nothing.
  const std::string& fault() const { return fault_; }

  void setCurves(const ClosedCurves& curves);

  /// N + 1 modes, and the remainder where there is one.
  int partCount() const { return split_.count(); }
  std::string name(int part) const;

  /// rows x (x, y, z of column 0, of column 1, ...), mm.
  RowMajor<double> contribution(int part) const;

  /// All parts' measures, in their order.
  /// @param goOn  asked before each part; when it says no, the result is empty
  std::vector<ModeMeasures> measures(const std::function<bool()>& goOn = [] { return true; }) const;

  /// The mean of the surface over u and v, mm.
  Eigen::RowVector3d centroid() const;

 private:
  Eigen::MatrixXd curvesOfPart(int part) const;
  double meanSquare(int part) const;

  HarmonicSplit split_;
  Eigen::VectorXd rowWeights_;      ///< sum to 1
  std::vector<Eigen::MatrixXd> u_;  ///< per part: rows x 29
  Eigen::MatrixXd synthesis_;       ///< columns x coefficients
  Eigen::Index columnCount_;
  Eigen::MatrixXd analysis_, samples_, coefficients_;
  std::string fault_;
};

/// The smallest N whose modes 0 .. N alone come as near to the surface as `tolerance` (mm, RMS), or -1 when all of
/// the modes leave more to the remainder. With N = K / 2 modes there is always one.
int smallestModeCount(const std::vector<ModeMeasures>& measures, double tolerance);

}  // namespace mien
