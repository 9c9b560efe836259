#include "OutputFolder.h"

#include <filesystem>

#include "Failure.h"

namespace mien {

void makeFolder(const std::string& name) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(name).has_filename() ? fs::path(name) : fs::path(name).parent_path();
  const fs::path above = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  if (!fs::is_directory(above, error))
    throw FileFailure(name + ": there is no folder " + above.string() + "; make it first");
  if (!fs::create_directory(folder, error))
    throw FileFailure(name + ": cannot be made a folder" + (error ? " (" + error.message() + ")" : ""));
}

}  // namespace mien
