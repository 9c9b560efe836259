#pragma once

#include <Eigen/Core>
#include <vector>

#include "AnimationTable.h"
#include "ClosedCurves.h"
#include "MotionBasis.h"

namespace mien {

/// Keeps two touching curves (lips, lids) from crossing [S 5].
///
/// The gap g_j = (upper - lower).y is made non-negative at the samples. As a gap that is non-negative at the
/// samples can be negative between them, it is then changed where it opens, as little as projections
/// onto the columns in between need, until its trigonometric interpolant stays above -0.09 mm on 10 K columns; should
/// that fail, it is drawn towards the neutral gap just far enough, which is exact as the interpolant is linear in it.
/// Where pressing curves meet: an upper lid stops at the lower; lips push each other by what each moves
/// on its own, so that a lip that moves alone goes all its way and the other gives way.
class ContactClamp {
 public:
  ContactClamp(const ClosedCurves& neutral, const ContactPair& pair, const MotionBasis& basis);

  /// Moves the samples of the two curves along y. Allocates nothing.
  void apply(const FAPFrame& frame, ClosedCurves& curves);

  void reset();  ///< forgets the last frame

  double clamped() const { return clamped_; }             ///< deepest crossing that was undone, mm
  int clampedSamples() const { return clampedSamples_; }  ///< samples that were moved

 private:
  bool measureGap(const ClosedCurves& curves);
  void interpolate();
  bool tooDeep() const;
  void liftOnce();
  void drawTowardsNeutral();
  void sumShared(const FAPFrame& frame);
  double meetingShift(int j, const ClosedCurves& curves) const;
  void moveCurves(const FAPFrame& frame, ClosedCurves& curves);

  struct SharedMotion {
    const PiecewiseLinear* intervals;
    int fap, interval;
    Eigen::VectorXd perValue;  ///< mm along y, K values, that move both curves alike
  };

  ContactPair pair_;
  Eigen::MatrixXd columns_;
  Eigen::VectorXd neutralUpper_, neutralLower_, neutralGap_, floor_, neutralValues_, mask_;
  Eigen::VectorXd rawGap_, gap_, values_, correction_, shared_;
  std::vector<SharedMotion> sharedMotions_;
  double clamped_ = 0.0;
  int clampedSamples_ = 0;
};

}  // namespace mien
