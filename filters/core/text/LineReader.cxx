#include "LineReader.h"

namespace mien {

bool LineReader::next() {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (number_ == 0 && rest_.substr(0, mark.size()) == mark) rest_.remove_prefix(mark.size());
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    const std::size_t first = line_.find_first_not_of(" \t\r,");
    if (first != std::string::npos && line_[first] != '#') return true;
  }
  return false;
}

}  // namespace mien
