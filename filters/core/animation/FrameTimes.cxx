#include "FrameTimes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "Counted.h"
#include "FAPParser.h"
#include "FrameNumbers.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double largestShare = 0.1;     // of a step that a time may be off the even ones
constexpr double largestGrowth = 100.0;  // gaps may make this many frames of one
constexpr double mostFrames = 1e6;
constexpr double usualRates[] = {24000.0 / 1001.0,
                                 24.0,
                                 25.0,
                                 30000.0 / 1001.0,
                                 30.0,
                                 48.0,
                                 50.0,
                                 60000.0 / 1001.0,
                                 60.0,
                                 90.0,
                                 100.0,
                                 120.0,
                                 240.0};
// How far a rate may be from a usual one to be taken as it: a time code counts whole frames, and a few of them jitter.
constexpr double rateTolerance = 0.005, clockTolerance = 0.02;
constexpr double largestDrift = 1.0;  // frames that a rate may be off at the end of the recording
constexpr double furthestRow = 0.75;  // frames that a row may be off its own; else the motion is mixed anew in time

/// Rows that bring the time forward.
std::vector<std::size_t> rowsThatAdvance(const std::vector<double>& seconds) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < seconds.size(); ++row)
    if (rows.empty() || seconds[row] > seconds[rows.back()]) rows.push_back(row);
  return rows;
}

/// How far times are from even ones, at most, in s.
double unevenness(const std::vector<double>& times, double rate) {
  double largest = 0.0;
  for (const double time : times) {
    const double steps = (time - times.front()) * rate;
    largest = std::max(largest, std::abs(steps - std::round(steps)) / rate);
  }
  return largest;
}

std::vector<double> usualRatesOf(double clockRate) {
  std::vector<double> rates;
  for (const double frames : {0.25, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
    if (clockRate > 0.0) rates.push_back(clockRate / frames);
  if (rates.empty()) rates.assign(std::begin(usualRates), std::end(usualRates));
  return rates;
}

/// The usual rate that a measured one stands for, else the measured one, rounded where that makes no difference.
double roundedRate(double rate, double frames, double clockRate) {
  const double tolerance = clockRate > 0.0 ? clockTolerance : rateTolerance;
  const auto drift = [&](double other) { return std::abs(other / rate - 1.0) * frames; };
  double nearest = 0.0;
  for (const double usual : usualRatesOf(clockRate))
    if (nearest == 0.0 || std::abs(usual - rate) < std::abs(nearest - rate)) nearest = usual;
  if (std::abs(nearest - rate) <= tolerance * nearest && drift(nearest) <= largestDrift) return nearest;
  const double shorter = std::round(rate * 1e3) / 1e3;
  return drift(shorter) <= largestShare ? shorter : rate;
}

/// A whole or broadcast rate where the times leave room for it, else a usual one.
double rateOf(const std::vector<double>& times, const FrameNumbers& frames, const FrameTimes& clock) {
  const double rate = 1.0 / frames.step;
  for (const double factor : {1.0, 1000.0 / 1001.0}) {
    const double whole = std::round(rate / factor) * factor;
    const bool isNear = std::abs(whole - rate) <= clockTolerance * rate;
    if (isNear && unevenness(times, whole) <= std::min(clock.clockError, largestShare / whole)) return whole;
  }
  return roundedRate(rate, frames.numbers.back(), clock.clockRate);
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

/// Mixes all frames anew at even times.
void fillSteps(const std::vector<double>& times, std::size_t count, FAPSequence& sequence) {
  const FAPMask mask = wholeMask(sequence);
  const double first = sequence.frames.front().number;
  std::vector<FAPFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    frames.push_back(frameAt(sequence, times, times.front() + i / sequence.framesPerSecond));
    frames.back().number = first + static_cast<double>(i);
  }
  sequence.frames = std::move(frames);
  sequence.masks.assign(count, mask);
}

/// Keeps every frame and mixes those that are missing from the two around.
void fillGaps(const std::vector<double>& numbers, bool hasNumbers, FAPSequence& sequence) {
  const FAPMask mask = wholeMask(sequence);
  std::vector<double> places;
  for (double number = 0.0; number <= numbers.back(); number += 1.0) places.push_back(number);
  std::vector<FAPFrame> frames;
  for (const double place : places) {
    frames.push_back(frameAt(sequence, numbers, place));
    if (!hasNumbers) frames.back().number = place;
  }
  sequence.frames = std::move(frames);
  sequence.masks.assign(places.size(), mask);
}

/// Steps over frames that nothing else in the file explains, and the row after the longest.
struct Gaps {
  std::size_t count = 0, longest = 1;
};

Gaps gapsOf(const FrameNumbers& frames, const std::vector<std::size_t>& rows, const std::vector<int>& lostBefore) {
  Gaps gaps;
  double longest = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double missing = frames.numbers[i] - frames.numbers[i - 1] - 1.0;
    const double lost = lostBefore.empty() ? 0.0 : lostBefore[rows[i]];
    gaps.count += missing > lost;
    if (missing <= longest) continue;
    longest = missing;
    gaps.longest = i;
  }
  return gaps;
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
  const FrameNumbers frames = FrameNumbers::of(times, clockRate);
  const Gaps gaps = gapsOf(frames, rows, lostBefore);
  const double rate = rateOf(times, frames, *this);
  if (!(rate >= slowestFAPRate && rate <= fastestFAPRate))
    return FAPParseError{lines[rows[1]],
                         "the times ask for " + std::to_string(rate) + " frames per second; give times in s"};
  const double count = frames.numbers.back() + 1.0;
  const double evenCount = std::round((times.back() - times.front()) * rate) + 1.0;
  const int line = lines[rows[gaps.longest]];
  if (std::max(count, evenCount) > std::min(mostFrames, largestGrowth * times.size()))
    return FAPParseError{line, "the time jumps too far to be filled; split the file here"};
  if (rows.size() < seconds.size())
    sequence.warnings.push_back(
        {lines.front(), "rows that repeat a time are left out: " + std::to_string(seconds.size() - rows.size())});
  keepRows(rows, sequence);
  sequence.framesPerSecond = rate;
  sequence.rateIsAssumed = false;
  const bool wanders = frames.largestJitter > furthestRow;
  if (wanders)
    fillSteps(times, static_cast<std::size_t>(evenCount), sequence);
  else if (count > static_cast<double>(times.size()))
    fillGaps(frames.numbers, hasNumbers, sequence);
  if (wanders || gaps.count > 0)
    sequence.warnings.push_back({line, "the frames are not evenly timed (" + counted(gaps.count, "gap") +
                                           "); frames between them are mixed from those around"});
  return std::nullopt;
}

std::string describeAssumedRate(bool hasTime) {
  return hasTime ? "a single time tells no rate; 25 frames per second are assumed"
                 : "there is no time; 25 frames per second are assumed";
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
