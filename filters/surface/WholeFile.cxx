#include "WholeFile.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

namespace mien {

WholeFile::~WholeFile() {
  std::error_code ignored;
  std::filesystem::remove(temporaryName_, ignored);
}

bool WholeFile::fill(const std::string& bytes) const {
  vtksys::ofstream file(temporaryName_.c_str(), std::ios::binary);
  file << bytes << std::flush;
  return static_cast<bool>(file);
}

bool WholeFile::commit() {
  std::error_code fault;
  std::filesystem::rename(temporaryName_, name_, fault);
  return !fault;
}

std::string WholeFile::write(const std::string& name, const std::string& bytes) {
  WholeFile file(name);
  return file.fill(bytes) && file.commit() ? std::string() : unwritable;
}

std::string WholeFile::temporaryNameOf(const std::string& name) {
  const std::filesystem::path path(name);
  // VTK's writer of .ply appends that ending to a name that ends in other letters than these.
  const std::string ending = vtksys::SystemTools::LowerCase(path.extension().string());
  const std::string hidden = "." + path.stem().string() + ".mien-" + std::to_string(getpid()) + ending;
  return (path.parent_path() / hidden).string();
}

}  // namespace mien
