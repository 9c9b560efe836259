#include "DataFile.h"

#include <filesystem>

namespace mien {

namespace fs = std::filesystem;

std::string findDataFile(const std::string& name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / MIEN_INSTALLED_DATA_DIR;
  for (const fs::path& folder : {installed, fs::path(MIEN_SOURCE_DATA_DIR)})
    if (fs::is_regular_file(folder / name, error)) return (folder / name).lexically_normal().string();
  return {};
}

}  // namespace mien
