#pragma once

#include <string>
#include <vector>

/// The cells of a CSV line whose quoted cells may hold commas.
inline std::vector<std::string> quotedCells(const std::string& line) {
  std::vector<std::string> result(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      result.emplace_back();
    else
      result.back() += c;
  }
  return result;
}
