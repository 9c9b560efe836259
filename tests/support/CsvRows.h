#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// The rows of a comma-separated table, header left out.
inline std::vector<std::vector<std::string>> csvRows(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    std::stringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}
