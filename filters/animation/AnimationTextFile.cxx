#include "AnimationTextFile.h"

#include <filesystem>
#include <iostream>
#include <system_error>
#include <vector>
#include <vtksys/FStream.hxx>

#include "FAPParser.h"

namespace mien {

namespace {

void readAll(std::istream& stream, std::string& text) {
  std::vector<char> block(std::size_t{1} << 16);
  while (stream && text.size() <= largestFAPText) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
}

}  // namespace

std::string shownAnimationName(const std::string& name) {
  return name == "-" ? "standard input" : name;
}

std::string readAnimationText(const std::string& name, std::string& text) {
  text.clear();
  std::error_code ignored;
  if (name == "-") {
    readAll(std::cin, text);
    return std::cin.bad() ? "reading it failed" : "";
  }
  if (std::filesystem::is_directory(name, ignored)) return "this is a folder; give a .fap or .csv file";
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  if (!file) return "it cannot be opened; give a .fap or .csv file that exists and may be read";
  readAll(file, text);
  return file.bad() ? "reading it failed; check the medium it is on" : "";
}

}  // namespace mien
