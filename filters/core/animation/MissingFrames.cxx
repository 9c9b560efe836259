#include "MissingFrames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "NumberText.h"

namespace mien {

namespace {

constexpr double longestNumberStep = 1.5;  // times the shortest; milliseconds of 30 frames per second step by 33 and 34

struct NumberGaps {
  double missing = 0.0, step = 1.0;  ///< frames, and numbers from one to the next
  std::size_t count = 0, first = 0;  ///< the frame behind the first gap
};

double stepBefore(const FAPSequence& sequence, std::size_t frame) {
  return sequence.frames[frame].number - sequence.frames[frame - 1].number;
}

/// None where numbers do not grow: they then say nothing.
NumberGaps numberGapsOf(const FAPSequence& sequence) {
  NumberGaps gaps;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < sequence.frames.size(); ++i) shortest = std::min(shortest, stepBefore(sequence, i));
  if (!(shortest > 0.0) || sequence.frames.size() < 2) return gaps;
  gaps.step = shortest;
  for (std::size_t i = 1; i < sequence.frames.size(); ++i) {
    const double steps = stepBefore(sequence, i) / shortest;
    if (!(steps > longestNumberStep)) continue;
    if (gaps.count++ == 0) gaps.first = i;
    gaps.missing += std::max(1.0, std::round(steps) - 1.0);
  }
  return gaps;
}

/// Numbers of milliseconds step by more than 1 as well.
bool skipEvenly(const FAPSequence& sequence, const NumberGaps& gaps) {
  constexpr double rounding = 0.1;
  const double steps = gaps.step * sequence.framesPerSecond / 1000.0;
  return gaps.count == 0 && gaps.step > 1.0 && std::abs(steps - 1.0) > rounding;
}

std::string firstGap(const FAPSequence& sequence, const NumberGaps& gaps) {
  const double before = sequence.frames[gaps.first - 1].number, behind = sequence.frames[gaps.first].number;
  if (gaps.step != 1.0) return "frames between " + numberText(before) + " and " + numberText(behind) + " are missing";
  if (behind - before == 2.0) return "frame " + numberText(before + 1.0) + " is missing";
  return "frames " + numberText(before + 1.0) + " to " + numberText(behind - 1.0) + " are missing";
}

}  // namespace

bool framesAreMissing(const FAPSequence& sequence) {
  const NumberGaps gaps = numberGapsOf(sequence);
  return gaps.count > 0 || skipEvenly(sequence, gaps);
}

std::optional<FAPWarning> describeMissingFrames(const FAPSequence& sequence, const std::vector<int>& lines) {
  if (lines.size() != sequence.frames.size()) return std::nullopt;
  const NumberGaps gaps = numberGapsOf(sequence);
  const bool skip = skipEvenly(sequence, gaps);
  if (gaps.count == 0 && !skip) return std::nullopt;
  std::string message = skip ? "the frame numbers step by " + numberText(gaps.step) : firstGap(sequence, gaps);
  if (gaps.count > 1)
    message += " (in all " + numberText(gaps.missing) + " in " + std::to_string(gaps.count) + " gaps)";
  message +=
      "; those that are there play one after the other, " + roundedText(sequence.framesPerSecond) + " per second";
  return FAPWarning{lines[std::max<std::size_t>(gaps.first, 1)], message};
}

}  // namespace mien
