#include "TimeCode.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "NumberText.h"

namespace mien {

namespace {

std::vector<std::string_view> splitAt(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end; (end = text.find(separator)) != text.npos; text.remove_prefix(end + 1))
    parts.push_back(text.substr(0, end));
  parts.push_back(text);
  return parts;
}

std::string padded(long long number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits - std::min(digits, text.size()), '0') + text;
}

bool isWhole(double number) {
  return number == std::floor(number);
}

}  // namespace

std::optional<TimeCode> parseTimeCode(std::string_view text) {
  TimeCode code;
  std::vector<std::string_view> parts = splitAt(text, ':');
  const std::size_t semicolon = parts.back().find(';');
  if (parts.size() == 3 && semicolon != std::string_view::npos) {
    const std::string_view last = parts.back();
    parts.back() = last.substr(0, semicolon);
    parts.push_back(last.substr(semicolon + 1));
    code.dropsNumbers = true;
  }
  if (parts.size() != 3 && parts.size() != 4) return std::nullopt;
  double values[4] = {};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<double> number = parseNumber(parts[i]);
    if (!number || *number < 0.0 || *number >= (i == 0 ? 1000.0 : i == 3 ? 1000.0 : 60.0)) return std::nullopt;
    values[i] = *number;
  }
  code.hasFrames = parts.size() == 4;
  if (!isWhole(values[0]) || !isWhole(values[1]) || (code.hasFrames && !isWhole(values[2]))) return std::nullopt;
  code.seconds = (values[0] * 60.0 + values[1]) * 60.0 + values[2];
  code.frames = values[3];
  return code;
}

double rateOfTimeCodes(double largestFrame, bool dropsNumbers) {
  double rate = std::floor(largestFrame) + 1.0;
  for (const double usual : {240.0, 120.0, 100.0, 60.0, 50.0, 48.0, 30.0, 25.0, 24.0})
    if (usual > std::floor(largestFrame) + 0.5) rate = usual;
  return dropsNumbers ? rate * 1000.0 / 1001.0 : rate;
}

std::string timeCodeText(double time) {
  constexpr long long rate = writtenTimeCodeRate;
  const auto thousandths = static_cast<long long>(std::llround(time * rate * 1000.0));
  const long long frames = thousandths / 1000, seconds = frames / rate;
  return padded(seconds / 3600 % 24, 2) + ":" + padded(seconds / 60 % 60, 2) + ":" + padded(seconds % 60, 2) + ":" +
         padded(frames % rate, 2) + "." + padded(thousandths % 1000, 3);
}

double secondsOf(const TimeCode& code, double rate) {
  if (!code.dropsNumbers) return code.seconds + code.frames / rate;
  const double nominal = std::round(rate), minutes = std::floor(code.seconds / 60.0);
  const double dropped = 2.0 * nominal / 30.0 * (minutes - std::floor(minutes / 10.0));
  return (code.seconds * nominal + code.frames - dropped) / rate;
}

}  // namespace mien
