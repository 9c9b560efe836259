#include "FAPSequence.h"

#include <algorithm>
#include <cmath>

#include "HighLevelMixture.h"

namespace mien {

namespace {

constexpr double intervalTolerance = 1e-6;  // of a frame interval; see doc/decisions.md

bool sets(const Viseme& v) {
  return v.select1 != 0.0 || v.select2 != 0.0 || v.blend != 0.0 || v.definition != 0.0;
}

bool sets(const Expression& e) {
  return e.select1 != 0.0 || e.select2 != 0.0 || e.intensity1 != 0.0 || e.intensity2 != 0.0 || e.initialFace != 0.0 ||
         e.definition != 0.0;
}

FAPMask maskOfValues(const FAPFrame& frame) {
  FAPMask mask;
  mask[0] = sets(frame.viseme);
  mask[1] = sets(frame.expression);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) mask[fap - 1] = frame.value(fap) != 0.0;
  return mask;
}

std::vector<int> numbersOf(const FAPMask& mask) {
  std::vector<int> numbers;
  for (int fap = 1; fap <= FAPFrame::count; ++fap)
    if (mask[fap - 1]) numbers.push_back(fap);
  return numbers;
}

double mix(double a, double b, double weight) {
  return (1.0 - weight) * a + weight * b;
}

FAPFrame mixture(const FAPFrame& before, const FAPFrame& after, double weight) {
  FAPFrame frame = before;
  frame.number = mix(before.number, after.number, weight);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    frame.setValue(fap, mix(before.value(fap), after.value(fap), weight));
  frame.viseme = mixture(before.viseme, after.viseme, weight);
  frame.expression = mixture(before.expression, after.expression, weight);
  return frame;
}

}  // namespace

FAPMask FAPSequence::mask(std::size_t index) const {
  const FAPMask written = index < masks.size() ? masks[index] : FAPMask();
  return written | maskOfValues(frames[index]);
}

std::vector<int> FAPSequence::fapsUsed() const {
  FAPMask all;
  for (std::size_t index = 0; index < frames.size(); ++index) all |= mask(index);
  return numbersOf(all);
}

std::vector<int> FAPSequence::fapsMoved() const {
  FAPMask all;
  for (const FAPFrame& frame : frames) all |= maskOfValues(frame);
  return numbersOf(all);
}

double FAPSequence::duration() const {
  return frames.empty() ? 0.0 : timeOfFrame(frames.size() - 1);
}

std::optional<std::size_t> FAPSequence::indexOfNumber(double number) const {
  const auto found =
      std::find_if(frames.begin(), frames.end(), [number](const FAPFrame& frame) { return frame.number == number; });
  if (found == frames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - frames.begin());
}

std::size_t FAPSequence::indexAtTime(double time) const {
  const double position = std::floor(time * framesPerSecond + intervalTolerance);
  if (!(position > 0.0)) return 0;  // also for a time that is not a number
  const std::size_t last = frames.size() - 1;
  return position < static_cast<double>(last) ? static_cast<std::size_t>(position) : last;
}

FAPFrame FAPSequence::frameAtTime(double time, bool interpolate) const {
  const std::size_t index = indexAtTime(time);
  const double weight = time * framesPerSecond - static_cast<double>(index);
  if (!interpolate || index + 1 == frames.size() || !(weight > intervalTolerance)) return frames[index];
  return mixture(frames[index], frames[index + 1], weight);
}

}  // namespace mien
