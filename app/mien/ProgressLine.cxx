#include "ProgressLine.h"

#include <unistd.h>

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
  if (total_ == 0) {
    std::fprintf(stderr, "%s%s %d", clearLine, what_, done);
    std::fflush(stderr);
    return;
  }
  const double left = done > 0 ? seconds(now - begin_) / done * (total_ - done) : 0.0;
  std::fprintf(stderr, "%s%s %d of %d, %.0f s left", clearLine, what_, done, total_, left);
  std::fflush(stderr);
}

}  // namespace mien
