#include <cmath>
#include <cstdint>
#include <string>

#include "AnimationTable.h"
#include "FAPFrame.h"
#include "FaceAnimator.h"
#include "Require.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

void requireUsable(const AnimationEntry& entry) {
  require(entry.fap >= FAPFrame::firstLowLevel && entry.fap <= FAPFrame::count && !entry.parts.empty());
  require(entry.replaces.empty() || entry.beyond.empty());
  for (const AnimationPart& part : entry.parts) {
    require(static_cast<int>(part.slopes.size()) == entry.intervals.intervals());
    for (const Eigen::Vector3d& slope : part.slopes) require(slope.allFinite());
    for (int curve : part.curves) require(curve >= 0 && curve < FaceLayout::curveCount);
    for (const ProfileKnot& knot : part.profile.knots)
      require(std::isfinite(knot.offset) && knot.weight >= 0 && knot.weight <= 1);
    require(part.profile.followsGap() || part.profile.knots.size() >= 2);
  }
}

/// What is accepted is bound to a face, or refused in a sentence; bound, it gives finite curves.
void requireBindable(const AnimationTable& table) {
  static const FaceCurves face = SyntheticFace::make(32);
  FaceAnimator animator;
  const std::string fault = animator.bind(face, table);
  require(fault.find('\n') == std::string::npos);
  if (!fault.empty()) return;
  FAPFrame frame;
  for (const AnimationEntry& entry : table.entries()) frame.setValue(entry.fap, 150.0);
  bool finite = true;
  const ClosedCurves& moved = animator.animate(frame);
  for (Eigen::Index i = 0; i < moved.points.size(); ++i) finite = finite && !std::isnan(moved.points.data()[i]);
  require(finite);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  AnimationTable table;
  const std::string fault = table.parse(text);
  if (!fault.empty()) {
    require(table.entries().empty() && fault.find('\n') == std::string::npos);
    return 0;
  }
  for (const AnimationEntry& entry : table.entries()) requireUsable(entry);
  for (const ContactPair& pair : table.contacts()) require(pair.lower == pair.upper + 1);
  requireBindable(table);
  return 0;
}
