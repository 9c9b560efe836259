#pragma once

#include <vector>

#include "AnimationTable.h"
#include "ClosedCurves.h"

namespace mien {

/// Makes room beside curves that moved far, so that no curve crosses its neighbour at a sample.
///
/// From the contacts (lips, lids) outwards a curve that comes nearer than a tenth of its neutral distance
/// is pushed on by its neighbour: the distance g becomes f^2 / (2f - g), f a tenth of the neutral
/// distance, which is smooth and stays positive. Where two sweeps meet without room for both, or for
/// absurd values, the whole face is drawn towards the neutral one just far enough. Curves in order stay bit for bit.
class CurveOrder {
 public:
  static constexpr double softShare = 0.1;

  CurveOrder(const ClosedCurves& neutral, const std::vector<ContactPair>& contacts);

  /// Moves samples along y only, except when the whole face is drawn back. Allocates nothing.
  void restore(ClosedCurves& curves);

  /// 1, or the share of the movement that was left when the whole face had to be drawn back.
  double keptShare() const { return keptShare_; }

  /// The furthest that a sample was pushed by its neighbour, mm; 0 when all had room.
  double pushed() const { return pushed_; }

  void reset();  ///< forgets the last frame

 private:
  struct Sweep {
    int from, to;  ///< curve that pushes first, last curve that is pushed
    double soft;   ///< share of the neutral distance below which curves are pushed
  };

  void push(ClosedCurves& curves, const Sweep& sweep);
  void drawBack(ClosedCurves& curves);

  const ClosedCurves& neutral_;
  std::vector<Sweep> sweeps_;
  double keptShare_ = 1.0;
  double pushed_ = 0.0;
};

}  // namespace mien
