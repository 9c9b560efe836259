#include "AnimationFrames.h"

#include "Arguments.h"
#include "CsvText.h"
#include "FAPSequence.h"
#include "Failure.h"
#include "InfoText.h"

#include <cmath>
#include <limits>

namespace mien {

namespace {

constexpr double mostFrames = 1e6;

struct Range {
  double first = -std::numeric_limits<double>::infinity(), last = std::numeric_limits<double>::infinity();
};

Range parseRange(const std::string& text) {
  Range range;
  if (text.empty()) return range;
  const std::vector<std::string> ends = splitText(text, ':');
  if (ends.size() != 2) throw ValueFailure("--range '" + text + "' is no range; write FIRST:LAST, FIRST: or :LAST");
  if (!ends[0].empty()) range.first = parseNumber("--range", ends[0]);
  if (!ends[1].empty()) range.last = parseNumber("--range", ends[1]);
  return range;
}

std::vector<size_t> indicesWithin(const FAPSequence& sequence, const std::string& text) {
  const Range range = parseRange(text);
  std::vector<size_t> indices;
  for (size_t index = 0; index < sequence.frames.size(); ++index)
    if (sequence.frames[index].number >= range.first && sequence.frames[index].number <= range.last)
      indices.push_back(index);
  if (indices.empty()) throw ValueFailure("--range '" + text + "' holds no frame; mien info FILE.fap tells their numbers");
  return indices;
}

std::string caption(const FAPSequence& sequence, double time) {
  return "frame " + shortestText(sequence.frames[sequence.indexAtTime(time)].number) + "   " + twoDigits(time) + " s";
}

std::vector<AnimationFrame> resampled(const FAPSequence& sequence, double begin, double end, double rate) {
  const double count = std::floor((end - begin) * rate + 1e-6) + 1.0;
  if (count > mostFrames) throw ValueFailure("--fps " + shortestText(rate) + " makes more than a million frames");
  std::vector<AnimationFrame> frames;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double time = begin + i / rate;
    frames.push_back({FaceState::FrameChoice::Time, time, time, caption(sequence, time)});
  }
  return frames;
}

}  // namespace

std::vector<AnimationFrame> chooseFrames(const FAPSequence& sequence, const std::string& range, double rate) {
  const std::vector<size_t> indices = indicesWithin(sequence, range);
  if (rate > 0.0)
    return resampled(sequence, sequence.timeOfFrame(indices.front()), sequence.timeOfFrame(indices.back()), rate);
  std::vector<AnimationFrame> frames;
  for (const size_t index : indices) {
    const double time = sequence.timeOfFrame(index);
    frames.push_back({FaceState::FrameChoice::Index, static_cast<double>(index), time, caption(sequence, time)});
  }
  return frames;
}

}  // namespace mien
