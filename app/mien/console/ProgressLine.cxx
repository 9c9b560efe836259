#include "ProgressLine.h"

#include <unistd.h>

#include <algorithm>
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
  if (!isDue()) return;
  std::string text = std::string(what_) + " " + std::to_string(done);
  if (total_ > 0) text += " of " + std::to_string(total_);
  write(text, total_ > 0 ? static_cast<double>(done) / total_ : 0.0);
}

void ProgressLine::showShare(double done) {
  if (isDue()) write(bar(done), done);
}

bool ProgressLine::isDue() {
  const Clock::time_point now = Clock::now();
  if (!visible_ || seconds(now - shown_) < secondsBetweenLines) return false;
  shown_ = now;
  return true;
}

void ProgressLine::write(const std::string& text, double share) {
  std::string left;
  if (share > 0.0)  // before that nobody knows
    left = ", " + readableTime(seconds(shown_ - begin_) / share * (1.0 - share)) + " left";
  std::fprintf(stderr, "%s%s%s", clearLine, text.c_str(), left.c_str());
  std::fflush(stderr);
}

std::string ProgressLine::bar(double share) {
  constexpr int width = 30;  // with the time it fits into 80 columns
  const double whole = std::clamp(share, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(std::floor(width * whole));
  const std::string percent = std::to_string(std::lround(std::floor(100.0 * whole)));
  return "[" + std::string(filled, '=') + std::string(width - filled, ' ') + "] " +
         std::string(3 - percent.size(), ' ') + percent + " %";
}

std::string ProgressLine::readableTime(double seconds) {
  const long whole = std::lround(std::ceil(seconds)), minutes = (whole + 59) / 60;
  if (whole < 2 * 60) return std::to_string(whole) + " s";
  if (minutes < 2 * 60) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

}  // namespace mien
