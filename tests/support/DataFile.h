#pragma once

#include <fstream>
#include <sstream>
#include <string>

/// The text of a file of the repository's data folder.
inline std::string readDataFile(const std::string& relative) {
  std::ifstream file(std::string(MIEN_DATA_DIR) + "/" + relative, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}
