#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mien {

/// A time of day as cameras count it: HH:MM:SS:FF with an optional fraction of a frame (FF.fff), HH:MM:SS.sss, or
/// HH:MM:SS;FF, which drops numbers (30000 / 1001 frames per second).
struct TimeCode {
  double seconds = 0.0;  ///< without the frames
  double frames = 0.0;   ///< and fractions of one
  bool hasFrames = false, dropsNumbers = false;
};

/// The time code in a text, or nothing.
std::optional<TimeCode> parseTimeCode(std::string_view text);

/// The usual rate that counts frames up to this one: 24, 25, 30, 48, 50, 60, 100, 120 or 240 per second.
double rateOfTimeCodes(double largestFrame, bool dropsNumbers);

/// The time in s since midnight. Where numbers are dropped, that is two per minute but every tenth at 30 per second.
double secondsOf(const TimeCode& code, double rate);

constexpr int writtenTimeCodeRate = 60;  ///< frames per second

/// "HH:MM:SS:FF.fff" at 60 frames per second, of a time in s since midnight; thousandths of a frame, the day wraps.
std::string timeCodeText(double seconds);

}  // namespace mien
