#include "TextFileReader.h"

#include <filesystem>
#include <system_error>
#include <vector>
#include <vtksys/FStream.hxx>

namespace mien {

std::string readTextFile(const std::string& name, std::size_t limit, std::string& text, const std::string& what) {
  std::error_code ignored;
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  if (std::filesystem::is_directory(name, ignored)) return " it is a folder; give a " + what;
  if (!file) return " it cannot be opened; give a " + what + " that exists and may be read";
  text.clear();
  readBlocks(file, limit, text);
  if (file.bad()) return " reading it failed; check the medium it is on";
  return text.size() > limit ? " it is too large for a " + what + ": more than " + std::to_string(limit) + " bytes"
                             : "";
}

void readBlocks(std::istream& stream, std::size_t limit, std::string& text) {
  std::vector<char> block(std::size_t{1} << 16);
  while (stream && text.size() <= limit) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
}

}  // namespace mien
