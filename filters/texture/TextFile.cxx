#include "TextFile.h"

#include <filesystem>
#include <system_error>
#include <vtksys/FStream.hxx>

namespace mien {

namespace {

// The largest warp mesh has 65,536 points and about 4 MB; a file larger than this is something else.
constexpr std::streamsize largestText = 10'000'000;

}  // namespace

std::string readSmallTextFile(const std::string& name, const std::string& what, std::string& text) {
  std::error_code ignored;
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  if (!file || std::filesystem::is_directory(name, ignored))
    return name + ": it cannot be opened; give a " + what + " that exists and may be read";
  text.assign(largestText, '\0');
  file.read(text.data(), largestText);
  if (file.gcount() == largestText) return name + ": it is too large for a " + what;
  text.resize(static_cast<std::size_t>(file.gcount()));
  return {};
}

}  // namespace mien
