#include "FAPStream.h"

#include <utility>

#include "FAPParser.h"

namespace mien {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

}  // namespace

std::optional<FAPParseError> FAPStream::feed(std::string_view bytes) {
  for (const char c : bytes) {
    const bool belongsToLast = std::exchange(afterReturn_, c == '\r') && c == '\n';
    if (belongsToLast) continue;
    if (c != '\n' && c != '\r') {
      if (line_.size() <= longestFAPLine) line_ += c;  // a longer one is refused when it ends
      continue;
    }
    if (std::exchange(isFirst_, false) && line_.compare(0, byteOrderMark.size(), byteOrderMark) == 0)
      line_.erase(0, byteOrderMark.size());
    const std::optional<FAPParseError> error = parser_.readLine(line_);
    line_.clear();
    if (error) return error;
  }
  return std::nullopt;
}

std::optional<FAPParseError> FAPStream::end() {
  if (!line_.empty())
    if (const auto error = feed("\n")) return error;
  return parser_.finish();
}

std::vector<FAPFrame> FAPStream::takeFrames() {
  return parser_.rateIsKnown() ? parser_.takeFrames() : std::vector<FAPFrame>();
}

}  // namespace mien
