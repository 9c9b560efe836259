#pragma once

#include <vector>

#include "AnimationTable.h"
#include "ClosedCurves.h"

namespace mien {

/// Keeps the samples of some curves in order from the middle of the face outwards, so that skin that is squeezed
/// sideways (the brows, FAP 37 and 38) is pressed together and does not fold over.
///
/// From the middle outwards a sample that comes nearer in x to its neighbour than a quarter of their neutral distance
/// is pushed on (softDistance); a sweep back from the widest sample, which stays, takes what is short of room. Samples
/// in order stay bit for bit.
class SideOrder {
 public:
  static constexpr double softShare = 0.25;

  SideOrder(const ClosedCurves& neutral, const std::vector<CurveBand>& bands);

  /// Moves samples along x only. Allocates nothing.
  void restore(ClosedCurves& curves);

  /// The furthest that a sample was pushed by its neighbour, mm; 0 when all had room.
  double pushed() const { return pushed_; }

  void reset() { pushed_ = 0.0; }  ///< forgets the last frame

 private:
  /// The samples of one curve on one side: from the middle one to the widest.
  struct Side {
    int curve, step, count;
  };
  void push(ClosedCurves& curves, const Side& side, int from, int direction, double soft);

  const ClosedCurves& neutral_;
  std::vector<Side> sides_;
  double pushed_ = 0.0;
};

}  // namespace mien
