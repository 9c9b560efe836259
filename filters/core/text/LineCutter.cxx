#include "LineCutter.h"

#include <algorithm>

namespace mien {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

}  // namespace

LineCutter::LineCutter(std::string_view text) : rest_(text) {
  if (rest_.substr(0, byteOrderMark.size()) == byteOrderMark) rest_.remove_prefix(byteOrderMark.size());
}

bool LineCutter::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const auto isEnd = [](char c) { return c == '\r' || c == '\n'; };
  const std::size_t end = std::find_if(rest_.begin(), rest_.end(), isEnd) - rest_.begin();
  line = rest_.substr(0, end);
  const std::size_t ending = rest_.substr(end, 2) == "\r\n" ? 2 : 1;
  rest_.remove_prefix(std::min(end + ending, rest_.size()));
  ++number_;
  return true;
}

}  // namespace mien
