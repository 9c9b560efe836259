#include "FrameTimes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "FAPParser.h"
#include "CountText.h"

namespace mien {

namespace {

constexpr double largestShare = 0.1;     // of a step that a time may be off the even ones
constexpr double largestGrowth = 100.0;  // gaps may make this many frames of one
constexpr double mostFrames = 1e6;

/// Rows that bring the time forward.
std::vector<std::size_t> rowsThatAdvance(const std::vector<double>& seconds) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < seconds.size(); ++row)
    if (rows.empty() || seconds[row] > seconds[rows.back()]) rows.push_back(row);
  return rows;
}

double usualStep(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  const std::size_t middle = (steps.size() - 1) / 2;  // of two the shorter: the other is a gap
  std::nth_element(steps.begin(), steps.begin() + middle, steps.end());
  return steps[middle];
}

double stepsFrom(double begin, double time, double rate) {
  return (time - begin) * rate;
}

/// How far times are from even ones, at most, in s.
double unevenness(const std::vector<double>& times, double rate) {
  double largest = 0.0;
  for (const double time : times) {
    const double steps = stepsFrom(times.front(), time, rate);
    largest = std::max(largest, std::abs(steps - std::round(steps)) / rate);
  }
  return largest;
}

/// The usual step averaged over all of them, and a whole or broadcast rate where the times leave room for it.
double rateOf(const std::vector<double>& times, double clockError) {
  const double step = usualStep(times);
  double count = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i) count += std::max(1.0, std::round((times[i] - times[i - 1]) / step));
  const double rate = count / (times.back() - times.front());
  for (const double factor : {1.0, 1000.0 / 1001.0}) {
    const double whole = std::round(rate / factor) * factor;
    if (whole > 0.0 && unevenness(times, whole) <= std::min(clockError, largestShare / whole)) return whole;
  }
  return rate;
}

std::string describeRepetitions(std::size_t count) {
  return countOf(count, "row") + (count == 1 ? " repeats a time and is left out" : " repeat a time and are left out");
}

bool isGap(double step, double rate) {
  return step * rate > 1.5;
}

/// A frame at a time between those of the recording.
FAPFrame frameAt(const FAPSequence& sequence, const std::vector<double>& times, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  const std::size_t index = std::min<std::size_t>(after - times.begin(), times.size() - 1);
  if (index == 0) return sequence.frames[0];
  FAPSequence pair;
  pair.framesPerSecond = 1.0 / (times[index] - times[index - 1]);
  pair.frames = {sequence.frames[index - 1], sequence.frames[index]};
  return pair.frameAtTime(std::min(time, times[index]) - times[index - 1], true);
}

void keepRows(const std::vector<std::size_t>& rows, FAPSequence& sequence) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    sequence.frames[i] = sequence.frames[rows[i]];
    if (!sequence.masks.empty()) sequence.masks[i] = sequence.masks[rows[i]];
  }
  sequence.frames.resize(rows.size());
  if (!sequence.masks.empty()) sequence.masks.resize(rows.size());
}

FAPMask wholeMask(const FAPSequence& sequence) {
  FAPMask all;
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) all |= sequence.mask(i);
  return all;
}

void fillSteps(const std::vector<double>& times, std::size_t count, FAPSequence& sequence) {
  const FAPMask mask = wholeMask(sequence);
  std::vector<FAPFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    frames.push_back(frameAt(sequence, times, times.front() + i / sequence.framesPerSecond));
    frames.back().number = static_cast<double>(i);
  }
  sequence.frames = std::move(frames);
  sequence.masks.assign(count, mask);
}

}  // namespace

std::optional<FAPParseError> FrameTimes::place(FAPSequence& sequence) const {
  for (std::size_t row = 1; row < seconds.size(); ++row)
    if (seconds[row] < seconds[row - 1] - clockError)
      return FAPParseError{lines[row], "the time goes back; sort the rows, or split the file where a recording ends"};
  const std::vector<std::size_t> rows = rowsThatAdvance(seconds);
  if (rows.size() < 2) return std::nullopt;
  std::vector<double> times;
  for (const std::size_t row : rows) times.push_back(seconds[row]);
  const double rate = rateOf(times, clockError);
  if (!(rate >= slowestFAPRate && rate <= fastestFAPRate))
    return FAPParseError{lines[rows[1]],
                         "the times ask for " + std::to_string(rate) + " frames per second; give times in s"};
  const double count = std::round(stepsFrom(times.front(), times.back(), rate)) + 1.0;
  std::size_t gaps = 0, longest = 1;
  for (std::size_t i = 1; i < times.size(); ++i) {
    gaps += isGap(times[i] - times[i - 1], rate);
    if (times[i] - times[i - 1] > times[longest] - times[longest - 1]) longest = i;
  }
  if (count > mostFrames || count > largestGrowth * times.size())
    return FAPParseError{lines[rows[longest]], "the time jumps too far to be filled; split the file here"};
  const int line = lines[rows[longest]];
  if (rows.size() < seconds.size())
    sequence.warnings.push_back(
        {lines.front(), describeRepetitions(seconds.size() - rows.size())});
  keepRows(rows, sequence);
  sequence.framesPerSecond = rate;
  sequence.rateIsAssumed = false;
  const bool even = gaps == 0 && count == static_cast<double>(times.size());
  if (!even || unevenness(times, rate) > 0.5 / rate - clockError) {
    fillSteps(times, static_cast<std::size_t>(count), sequence);
    sequence.warnings.push_back({line, "the frames are not evenly timed (" + countOf(gaps, "gap") +
                                           "); frames between them are mixed from those around"});
  }
  return std::nullopt;
}

std::optional<FAPSequence> resampled(const FAPSequence& sequence, double framesPerSecond) {
  const double count = std::floor(sequence.duration() * framesPerSecond + 1e-6) + 1.0;
  if (!(count <= mostFrames)) return std::nullopt;
  FAPSequence result = sequence;
  result.framesPerSecond = framesPerSecond;
  result.rateIsAssumed = false;
  result.frames.clear();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    result.frames.push_back(sequence.frameAtTime(i / framesPerSecond, true));
    result.frames.back().number = static_cast<double>(i);
  }
  result.masks.assign(result.frames.size(), wholeMask(sequence));
  return result;
}

}  // namespace mien
