#pragma once

#include <string>
#include <string_view>

namespace mien {

/// The lines of a comma-separated text that say something: neither empty nor comments (#). A byte order mark is
/// skipped.
class LineReader {
 public:
  /// The text must outlive the reader.
  explicit LineReader(std::string_view text) : rest_(text) {}

  /// Goes to the next line; false at the end of the text.
  bool next();

  const std::string& line() const { return line_; }
  int number() const { return number_; }  ///< of that line in the text, from 1; at the end of the text that of the last

 private:
  std::string_view rest_;
  std::string line_;
  int number_ = 0;
};

}  // namespace mien
