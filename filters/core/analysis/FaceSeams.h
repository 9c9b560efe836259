#pragma once

#include <array>
#include <string>
#include <vector>

#include "ClosedCurves.h"
#include "FaceSurface.h"
#include "HarmonicSplit.h"
#include "SeamSummary.h"

namespace mien {

/// The eight seams P0|P1 .. P7|P8 of a PDE face, measured from both sides at equidistant v.
///
/// The jets are those of the solutions on either side, so nothing is differenced. P6|P7 is the mouth: while the lips
/// are apart its gap and angle are those between C22 and C22'.
class FaceSeams {
 public:
  static constexpr int seamCount = FaceLayout::patchCount - 1;
  static constexpr int defaultColumns = 400;
  static constexpr double frontalZ = 50.0;  ///< mm; the front of the face lies beyond

  /// Makes the operators, which stay good for all curves of K points.
  FaceSeams(const FaceSurfaceOptions& options, int pointsPerCurve, int columns = defaultColumns);

  /// One sentence when the scheme's conditions determine no surface, or nothing.
  const std::string& fault() const { return fault_; }

  /// Measures all seams of new curves.
  void setCurves(const ClosedCurves& curves);

  int columnCount() const { return static_cast<int>(v_.size()); }
  double v(int column) const { return v_[column]; }

  /// "P0|P1" .. "P7|P8".
  static std::string name(int seam);

  /// side 0: of the patch that ends in the seam, side 1: of the patch that begins there.
  SurfaceJet jet(int seam, int side, int column) const;

  /// The middle between both sides, mm.
  Eigen::Vector3d position(int seam, int column) const;

  const SeamMeasures& measures(int seam, int column) const { return measures_[seam * columnCount() + column]; }

  /// Over the whole seam.
  const SeamSummary& whole(int seam) const { return whole_[seam]; }
  /// Over its samples with z > frontalZ.
  const SeamSummary& frontal(int seam) const { return frontal_[seam]; }

 private:
  void addSide(const SurfacePiece& piece, int row);
  void computeJets(const ClosedCurves& curves);
  void measure(int seam);

  Eigen::VectorXd v_;
  HarmonicSplit split_;
  std::string fault_;
  Eigen::MatrixXd analysis_;
  std::array<Eigen::MatrixXd, 3> synthesis_;  ///< columns x K, by order of the derivative with respect to v
  /// Per part of the split, coefficients of curves to coefficients of the seams' sides: 3 x 29 rows; columns x, y, z of
  /// S of all 16 sides, then of S_u, then of S_uu.
  std::vector<Eigen::MatrixXd> sides_;
  Eigen::MatrixXd samples_, ofCurves_, ofSides_;
  std::array<Eigen::MatrixXd, 3> jets_;  ///< columns x (as in sides_), by order of the derivative with respect to v
  std::vector<SeamMeasures> measures_;
  std::array<SeamSummary, seamCount> whole_, frontal_;
};

}  // namespace mien
