#include "AnimationFrames.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// In the order of the file, whatever that of the option.
std::vector<size_t> chosenIndices(const FAPSequence& sequence, const FrameOptions& options) {
  if (options.rangeText().empty()) {
    std::vector<size_t> all(sequence.frames.size());
    std::iota(all.begin(), all.end(), size_t{0});
    return all;
  }
  std::vector<size_t> indices = frameIndices(options.rangeOption(), options.rangeText(), sequence);
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

std::string caption(const FAPSequence& sequence, double time) {
  return "frame " + shortestText(sequence.frames[sequence.indexAtTime(time)].number) + "   " + twoDigits(time) + " s";
}

/// Begin and end in s, by frame numbers and by times.
struct Times {
  double begin, end;
};

/// A time given by an option; one outside the animation is refused, as the number of a frame is.
double parseTime(const char* option, const std::string& text, const FAPSequence& sequence) {
  const double time = parseNumber(option, text);
  if (!(time >= 0.0 && time < sequence.duration() + 1.0 / sequence.framesPerSecond))
    throw ValueFailure(std::string(option) + " " + text + " lies outside the animation, which lasts from 0 to " +
                       shortestText(sequence.duration()) + " s");
  return time;
}

Times chooseTimes(const FAPSequence& sequence, const FrameOptions& options, const std::vector<size_t>& indices) {
  Times times{sequence.timeOfFrame(indices.front()), sequence.timeOfFrame(indices.back())};
  if (!options.start.empty()) times.begin = std::max(times.begin, parseTime("--start", options.start, sequence));
  if (!options.end.empty()) times.end = std::min(times.end, parseTime("--end", options.end, sequence));
  if (times.begin > times.end + timeTolerance)
    throw ValueFailure("--start and --end hold no frame; those chosen last from " +
                       shortestText(sequence.timeOfFrame(indices.front())) + " to " +
                       shortestText(sequence.timeOfFrame(indices.back())) + " s");
  return times;
}

std::vector<AnimationFrame> resampled(const FAPSequence& sequence, const Times& times, double rate) {
  const double count = std::floor((times.end - times.begin) * rate + timeTolerance) + 1.0;
  if (count > mostFrames) throw ValueFailure("--fps " + shortestText(rate) + " makes more than a million frames");
  std::vector<AnimationFrame> frames;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double time = times.begin + i / rate;
    frames.push_back({FaceState::FrameChoice::Time, time, time, caption(sequence, time), ""});
  }
  return frames;
}

std::vector<AnimationFrame> asWritten(const FAPSequence& sequence, const Times& times,
                                      const std::vector<size_t>& indices) {
  std::vector<AnimationFrame> frames;
  for (const size_t index : indices) {
    const double time = sequence.timeOfFrame(index);
    if (time >= times.begin - timeTolerance && time <= times.end + timeTolerance)
      frames.push_back({FaceState::FrameChoice::Index, static_cast<double>(index), time, caption(sequence, time),
                        shortestText(sequence.frames[index].number)});
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
  const std::vector<size_t> indices = chosenIndices(sequence, options);
  const Times times = chooseTimes(sequence, options, indices);
  const double rate = options.rate();
  if (rate > 0.0 && isFrameList(options.rangeText()))
    throw ValueFailure(std::string(options.rangeOption()) + " " + options.rangeText() +
                       " names single frames, between which --fps cannot mix; give a range FIRST:LAST");
  std::vector<AnimationFrame> frames =
      rate > 0.0 ? resampled(sequence, times, rate) : asWritten(sequence, times, indices);
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
