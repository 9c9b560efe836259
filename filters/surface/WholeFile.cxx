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
  return !replace(name_, temporaryName_);
}

std::string WholeFile::targetOf(const std::string& name) {
  std::error_code fault;
  if (!std::filesystem::is_symlink(name, fault)) return name;
  const std::filesystem::path target = std::filesystem::canonical(name, fault);
  return fault ? name : target.string();
}

std::error_code WholeFile::replace(const std::string& name, const std::string& temporaryName) {
  std::error_code fault;
  const std::filesystem::file_status before = std::filesystem::status(name, fault);
  if (std::filesystem::is_regular_file(before))
    std::filesystem::permissions(temporaryName, before.permissions(), fault);  // as well as may be
  std::filesystem::rename(temporaryName, name, fault);
  return fault;
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
