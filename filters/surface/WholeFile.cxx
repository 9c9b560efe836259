#include "WholeFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "SmallLetters.h"

namespace mien {

namespace {

constexpr size_t blockSize = 4096;  // bytes, of most disks

std::error_code lastFault() {
  return {errno, std::generic_category()};
}

/// Appends a block and takes it away again.
std::error_code tryBlockBehind(int file) {
  struct stat before;
  if (fstat(file, &before) != 0) return lastFault();
  const std::array<char, blockSize> block = {};
  const ssize_t written = write(file, block.data(), block.size());
  if (written < 0) return lastFault();
  if (ftruncate(file, before.st_size) != 0) return lastFault();
  return written == ssize_t(block.size()) ? std::error_code() : std::make_error_code(std::errc::no_space_on_device);
}

/// Some of VTK's writers (.ply, .obj) do not ask whether their bytes arrive: half a file looks whole to them. But where
/// a disk was full, no block fits behind what it took.
std::error_code faultBehind(const std::string& name) {
  const int file = open(name.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file < 0) return lastFault();
  const std::error_code fault = tryBlockBehind(file);
  return close(file) == 0 ? fault : lastFault();
}

}  // namespace

WholeFile::~WholeFile() {
  std::error_code ignored;
  std::filesystem::remove(temporaryName_, ignored);
}

bool WholeFile::fill(const std::string& bytes) const {
  std::ofstream file(temporaryName_, std::ios::binary);
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
  std::error_code fault = faultBehind(temporaryName);
  if (fault) return fault;
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
  const std::string ending = inSmallLetters(path.extension().string());
  const std::string hidden = "." + path.stem().string() + ".mien-" + std::to_string(getpid()) + ending;
  return (path.parent_path() / hidden).string();
}

}  // namespace mien
