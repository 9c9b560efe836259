#include "AnimationTextFile.h"

#include <filesystem>
#include <iostream>
#include <system_error>
#include <vtksys/FStream.hxx>

#include "FAPParser.h"
#include "TextFileReader.h"

namespace mien {

std::string shownAnimationName(const std::string& name) {
  return name == "-" ? "standard input" : name;
}

std::string readAnimationText(const std::string& name, std::string& text) {
  text.clear();
  std::error_code ignored;
  if (name == "-") {
    readBlocks(std::cin, largestFAPText, text);
    return std::cin.bad() ? "reading it failed" : "";
  }
  if (std::filesystem::is_directory(name, ignored)) return "this is a folder; give a .fap or .csv file";
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  if (!file) return "it cannot be opened; give a .fap or .csv file that exists and may be read";
  readBlocks(file, largestFAPText, text);
  return file.bad() ? "reading it failed; check the medium it is on" : "";
}

}  // namespace mien
