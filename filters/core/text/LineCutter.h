#pragma once

#include <string_view>

namespace mien {

/// Takes the lines off a text one by one; they end in LF, CR LF or CR. A byte order mark at the start is left out.
class LineCutter {
 public:
  explicit LineCutter(std::string_view text);

  /// @return whether there was one more line
  bool next(std::string_view& line);

  int number() const { return number_; }  ///< of the line given last, from 1

 private:
  std::string_view rest_;
  int number_ = 0;
};

}  // namespace mien
