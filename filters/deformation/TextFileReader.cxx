#include "TextFileReader.h"

#include <filesystem>
#include <system_error>
#include <vtksys/FStream.hxx>

namespace mien {

std::string readTextFile(const std::string& name, std::size_t limit, std::string& text) {
  std::error_code ignored;
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  if (!file || std::filesystem::is_directory(name, ignored))
    return " it cannot be opened; give a file that exists and may be read";
  text.assign(limit, '\0');
  file.read(text.data(), static_cast<std::streamsize>(limit));
  if (static_cast<std::size_t>(file.gcount()) == limit) return " it is too large for what it should be";
  text.resize(static_cast<std::size_t>(file.gcount()));
  return {};
}

}  // namespace mien
