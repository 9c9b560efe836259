#pragma once

#include <string>

#include "TextFile.h"

/// The text of a file of the repository's data folder.
inline std::string readDataFile(const std::string& relative) {
  return readTextFile(std::string(MIEN_DATA_DIR) + "/" + relative);
}
