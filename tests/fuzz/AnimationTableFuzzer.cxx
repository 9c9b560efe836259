#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "AnimationTable.h"
#include "FAPFrame.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

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
  return 0;
}
