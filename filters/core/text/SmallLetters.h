#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace mien {

/// The text with its ASCII letters small; names in files are compared so.
inline std::string inSmallLetters(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return small;
}

}  // namespace mien
