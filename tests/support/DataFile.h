#pragma once

#include "TextFile.h"

#include <string>

/// The text of a file of the repository's data folder.
inline std::string readDataFile(const std::string& relative) {
  return readTextFile(std::string(MIEN_DATA_DIR) + "/" + relative);
}
