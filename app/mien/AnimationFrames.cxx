#include "AnimationFrames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Arguments.h"
#include "CsvText.h"
#include "FAPSequence.h"
#include "Failure.h"
#include "FrameOptions.h"
#include "InfoText.h"

namespace mien {

namespace {

constexpr double mostFrames = 1e6;
constexpr double timeTolerance = 1e-6;  // s, and of a step

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
  if (indices.empty())
    throw ValueFailure("--range '" + text + "' holds no frame; mien info FILE.fap tells their numbers");
  return indices;
}

std::string caption(const FAPSequence& sequence, double time) {
  return "frame " + shortestText(sequence.frames[sequence.indexAtTime(time)].number) + "   " + twoDigits(time) + " s";
}

/// Begin and end in s, by frame numbers and by times.
struct Times {
  double begin, end;
};

Times chooseTimes(const FAPSequence& sequence, const FrameOptions& options) {
  const std::vector<size_t> indices = indicesWithin(sequence, options.range);
  Times times{sequence.timeOfFrame(indices.front()), sequence.timeOfFrame(indices.back())};
  if (!options.start.empty()) times.begin = std::max(times.begin, parseNumber("--start", options.start));
  if (!options.end.empty()) times.end = std::min(times.end, parseNumber("--end", options.end));
  if (times.begin > times.end + timeTolerance)
    throw ValueFailure("--start and --end hold no frame; the animation lasts from 0 to " +
                       shortestText(sequence.duration()) + " s");
  return times;
}

std::vector<AnimationFrame> resampled(const FAPSequence& sequence, const Times& times, double rate) {
  const double count = std::floor((times.end - times.begin) * rate + timeTolerance) + 1.0;
  if (count > mostFrames) throw ValueFailure("--fps " + shortestText(rate) + " makes more than a million frames");
  std::vector<AnimationFrame> frames;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double time = times.begin + i / rate;
    frames.push_back({FaceState::FrameChoice::Time, time, time, caption(sequence, time)});
  }
  return frames;
}

std::vector<AnimationFrame> asWritten(const FAPSequence& sequence, const Times& times, const std::string& range) {
  std::vector<AnimationFrame> frames;
  for (const size_t index : indicesWithin(sequence, range)) {
    const double time = sequence.timeOfFrame(index);
    if (time >= times.begin - timeTolerance && time <= times.end + timeTolerance)
      frames.push_back({FaceState::FrameChoice::Index, static_cast<double>(index), time, caption(sequence, time)});
  }
  if (frames.empty()) throw ValueFailure("--start and --end lie between two frames; give --fps to mix frames there");
  return frames;
}

}  // namespace

double rateOf(const FAPSequence& sequence, const FrameOptions& options) {
  const double rate = options.rate();
  return rate > 0.0 ? rate : sequence.framesPerSecond;
}

std::vector<AnimationFrame> chooseFrames(const FAPSequence& sequence, const FrameOptions& options) {
  const Times times = chooseTimes(sequence, options);
  const double rate = options.rate();
  std::vector<AnimationFrame> frames =
      rate > 0.0 ? resampled(sequence, times, rate) : asWritten(sequence, times, options.range);
  const int repetitions = options.repetitions();
  const size_t count = frames.size();
  if (static_cast<double>(count) * repetitions > mostFrames)
    throw ValueFailure("--loop " + options.loop + " makes more than a million frames");
  const double period = frames.back().time - frames.front().time + 1.0 / rateOf(sequence, options);
  for (int repetition = 1; repetition < repetitions; ++repetition)
    for (size_t i = 0; i < count; ++i) {
      frames.push_back(frames[i]);
      frames.back().time += repetition * period;
    }
  return frames;
}

}  // namespace mien
