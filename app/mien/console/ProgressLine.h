#pragma once

#include <chrono>
#include <string>

namespace mien {

/// How far a command is and how long it will take, in one line on stderr when that is a terminal; nothing otherwise.
class ProgressLine {
 public:
  /// @param total  how many there will be; 0 when nobody knows
  explicit ProgressLine(int total = 0, const char* what = "frame");
  ~ProgressLine();  ///< takes the line away
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(int done);
  void showShare(double done);  ///< of a whole that has no number: a bar, 0 .. 1

  /// "42 s", "12 min", "3 h 20 min".
  static std::string readableTime(double seconds);

  /// "[==========          ]  50 %".
  static std::string bar(double share);

 private:
  bool isDue();
  void write(const std::string& text, double share);

  using Clock = std::chrono::steady_clock;

  int total_;
  const char* what_;
  bool visible_;
  Clock::time_point begin_ = Clock::now(), shown_;
};

}  // namespace mien
