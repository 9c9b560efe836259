#pragma once

#include <fstream>
#include <iterator>
#include <string>

/// All bytes of a file, or an empty text.
inline std::string readTextFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline void writeTextFile(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}
