#include "FrameOptions.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "Arguments.h"
#include "CsvText.h"
#include "FAPSequence.h"
#include "Failure.h"

namespace mien {

namespace {

constexpr int mostRepetitions = 10000;

struct Range {
  double first = -std::numeric_limits<double>::infinity(), last = std::numeric_limits<double>::infinity();
};

Range parseRange(const std::string& option, const std::string& text) {
  const std::vector<std::string> ends = splitText(text, ':');
  if (ends.size() > 2 || text.empty() || text == ":")
    throw ValueFailure(option + " '" + text + "' is no range of frames; write FIRST:LAST, FIRST:, :LAST or a number");
  Range range;
  if (!ends.front().empty()) range.first = parseNumber(option, ends.front());
  if (ends.size() == 1) range.last = range.first;
  if (ends.size() == 2 && !ends.back().empty()) range.last = parseNumber(option, ends.back());
  return range;
}

/// A range that goes past the file is a slip, as the number of a frame is that it does not have.
void requireWithin(const Range& range, const std::string& option, const std::string& item,
                   const FAPSequence& sequence) {
  const auto less = [](const FAPFrame& a, const FAPFrame& b) { return a.number < b.number; };
  const auto [least, most] = std::minmax_element(sequence.frames.begin(), sequence.frames.end(), less);
  const bool before = std::isfinite(range.first) && range.first < least->number;
  const bool after = std::isfinite(range.last) && range.last > most->number;
  if (before || after)
    throw ValueFailure(option + " '" + item + "' reaches beyond the animation, whose frames run from " +
                       shortestText(least->number) + " to " + shortestText(most->number) +
                       "; leave an end of FIRST:LAST out for all up to there");
}

}  // namespace

std::vector<std::size_t> frameIndices(const std::string& option, const std::string& text, const FAPSequence& sequence) {
  std::vector<std::size_t> indices;
  for (const std::string& item : splitText(text, ',')) {
    const Range range = parseRange(option, item);
    const std::size_t known = indices.size();
    for (std::size_t index = 0; index < sequence.frames.size(); ++index)
      if (sequence.frames[index].number >= range.first && sequence.frames[index].number <= range.last)
        indices.push_back(index);
    if (indices.size() == known)
      throw ValueFailure(option + " '" + item + "' holds no frame; their numbers run from " +
                         shortestText(sequence.frames.front().number) + " to " +
                         shortestText(sequence.frames.back().number));
    requireWithin(range, option, item, sequence);
  }
  return indices;
}

bool isFrameList(const std::string& text) {
  return text.find(',') != std::string::npos;
}

void FrameOptions::addTo(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->check(isNotEmpty);
  };
  CLI::Option* whole = add("--range", range,
                           "Frame numbers as written in the file: FIRST:LAST, or several such as 1,5,9 or 1,5:9 [all]");
  add("--frames", frames, "The same")->excludes(whole);
  add("--start", start, "From this time on, s from the first frame [0]");
  add("--end", end, "Up to this time, s from the first frame [the last]");
  add("--fps", fps, "Moments per second, mixed from the frames around them [the frames]");
  add("--loop", loop, "How many times, one after the other [1]");
}

double FrameOptions::rate() const {
  const double value = fps.empty() ? 0.0 : parseNumber("--fps", fps);
  if (!fps.empty() && !(value > 0.0 && value <= 1000.0))
    throw ValueFailure("--fps " + fps + " is outside 0 < fps <= 1000");
  return value;
}

int FrameOptions::repetitions() const {
  const int times = loop.empty() ? 1 : parseWholeNumber("--loop", loop);
  if (times < 1 || times > mostRepetitions)
    throw ValueFailure("--loop " + loop + " is outside 1 .. " + std::to_string(mostRepetitions));
  return times;
}

}  // namespace mien
