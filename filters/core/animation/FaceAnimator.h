#pragma once

#include <memory>
#include <string>
#include <vector>

#include "AnimationTable.h"
#include "ContactClamp.h"
#include "CurveOrder.h"
#include "EffectiveValues.h"
#include "FAPFrame.h"
#include "FAPUnits.h"
#include "FaceCurves.h"
#include "MotionBasis.h"
#include "SideOrder.h"

namespace mien {

/// Moves the boundary curves of a face by FAPs: value x unit / 1024 x direction x weight [S 5].
///
/// A zero frame gives the neutral curves bit for bit. Weights of FAPs that share points sum to at most
/// 1, and where their directions differ the shift along x and z gives way, so that no such point moves further than
/// the largest single displacement. FAPs that move the same place (inner and outer lip) do not move it twice
/// (EffectiveValues). Lips and lids touch but do not cross; no curve crosses its neighbour at a sample.
class FaceAnimator {
 public:
  static constexpr int minimumPointsPerCurve = 32;

  /// Measures the units and binds the table to the face; on a fault the animator stays as it was.
  /// @return nothing, or one sentence that says what is wrong
  std::string bind(const FaceCurves& neutral, const AnimationTable& table);

  /// The moved curves, valid until the next call. Allocates nothing. Needs a successful bind().
  const ClosedCurves& animate(const FAPFrame& frame);

  const FaceCurves& neutral() const;
  const FAPUnits& units() const;
  const MotionBasis& basis() const;

  double contactClamped() const;  ///< deepest crossing of lips or lids that the last frame undid, mm
  int contactSamples() const;     ///< how many samples that moved
  double pushed() const;          ///< furthest that a curve gave way because its neighbour left it no room, mm
  double keptShare() const;       ///< 1, or what was left of the movement of a frame with absurd values

  /// FAPs that the frame sets and nothing on this face answers to; 1 and 2 when a viseme or expression is selected.
  std::vector<int> ignoredFAPs(const FAPFrame& frame) const;

 private:
  struct Binding {
    Binding(const FaceCurves& face, const AnimationTable& table) : neutral(face), animated(face.curves), table(table) {}
    FaceCurves neutral;
    ClosedCurves animated;
    AnimationTable table;
    FAPUnits units;
    MotionBasis basis;
    std::vector<ContactClamp> contacts;
    std::unique_ptr<EffectiveValues> values;
    std::unique_ptr<CurveOrder> order;
    std::unique_ptr<SideOrder> sides;
    std::vector<int> groups;    ///< per sample: the group that moves it, or -1
    std::vector<double> slack;  ///< per sample: how far FAPs outside that group move it in this frame, mm
  };

  bool displace(const FAPFrame& frame);
  void limitGroups(const FAPFrame& frame);

  std::unique_ptr<Binding> bound_;
};

}  // namespace mien
