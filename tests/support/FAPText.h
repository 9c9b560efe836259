#pragma once

#include <initializer_list>
#include <string>

/// A mask line that is 1 at these FAPs, without its line ending.
inline std::string maskText(std::initializer_list<int> faps, int entries = 68) {
  std::string text;
  for (int entry = 0; entry < entries; ++entry) text += entry == 0 ? "0" : " 0";
  for (int fap : faps) text[2 * (fap - 1)] = '1';
  return text;
}
