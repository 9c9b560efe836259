#include "FrameOptions.h"

#include <CLI/CLI.hpp>

#include "Arguments.h"
#include "Failure.h"

namespace mien {

namespace {

constexpr int mostRepetitions = 10000;

}  // namespace

void FrameOptions::addTo(CLI::App& command) {
  command.add_option("--range,--frames", range, "FIRST:LAST, frame numbers as written in the file [all]");
  command.add_option("--start", start, "From this time on, s from the first frame [0]");
  command.add_option("--end", end, "Up to this time, s from the first frame [the last]");
  command.add_option("--fps", fps, "Moments per second, mixed from the frames around them [the frames]");
  command.add_option("--loop", loop, "How many times, one after the other [1]");
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
