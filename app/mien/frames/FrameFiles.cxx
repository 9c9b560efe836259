#include "FrameFiles.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "OutputFolder.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

std::string numbered(const std::string& stem, long index, const std::string& ending) {
  char number[32];
  std::snprintf(number, sizeof number, "_%04ld.", index);
  return stem + number + ending;
}

}  // namespace

FrameFiles::FrameFiles(const std::string& folder, const std::string& stem, const std::string& ending,
                       const std::vector<std::string>& earlierEndings)
    : folder_(folder), stem_(stem), ending_(ending), earlierEndings_(earlierEndings) {
  makeFolder(folder);
}

std::string FrameFiles::name(int index) const {
  return numbered(stem_, index, ending_);
}

std::string FrameFiles::path(int index) const {
  return (fs::path(folder_) / name(index)).string();
}

bool FrameFiles::isEarlier(const std::string& name, int count) const {
  if (name.compare(0, stem_.size() + 1, stem_ + "_") != 0) return false;
  const long index = std::strtol(name.c_str() + stem_.size() + 1, nullptr, 10);
  if (index >= count && name == numbered(stem_, index, ending_)) return true;
  for (const std::string& ending : earlierEndings_)
    if (ending != ending_ && index >= 0 && name == numbered(stem_, index, ending)) return true;
  return false;
}

void FrameFiles::removeOthers(int count) const {
  if (count == 0) return;
  std::error_code error;
  std::vector<fs::path> earlier;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error))
    if (isEarlier(entry.path().filename().string(), count)) earlier.push_back(entry.path());
  for (const fs::path& path : earlier) fs::remove(path, error);
}

}  // namespace mien
