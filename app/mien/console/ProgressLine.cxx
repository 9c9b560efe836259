#include "ProgressLine.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace mien {

namespace {

constexpr double secondsBetweenLines = 0.2;
const char* const clearLine = "\r\033[K";

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

ProgressLine::ProgressLine(int total, const char* what)
    : total_(total), what_(what), visible_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (visible_) std::fputs(clearLine, stderr);
}

void ProgressLine::show(int done) {
  const Clock::time_point now = Clock::now();
  if (!visible_ || seconds(now - shown_) < secondsBetweenLines) return;
  shown_ = now;
  std::string text = std::string(what_) + " " + std::to_string(done);
  if (total_ > 0) text += " of " + std::to_string(total_);
  if (total_ > 0 && done > 0)  // before that nobody knows
    text += ", " + readableTime(seconds(now - begin_) / done * (total_ - done)) + " left";
  std::fprintf(stderr, "%s%s", clearLine, text.c_str());
  std::fflush(stderr);
}

std::string ProgressLine::readableTime(double seconds) {
  const long whole = std::lround(std::ceil(seconds)), minutes = (whole + 59) / 60;
  if (whole < 2 * 60) return std::to_string(whole) + " s";
  if (minutes < 2 * 60) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace mien
