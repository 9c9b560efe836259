#pragma once

#include <string>

#include "MienSurfaceModule.h"

namespace mien {

/// A file that appears only when it is complete: it is written under a temporary name beside its own, and commit()
/// renames it. What was there before is replaced whole or not at all.
class MIENSURFACE_EXPORT WholeFile {
 public:
  explicit WholeFile(const std::string& name) : name_(name), temporaryName_(temporaryNameOf(name)) {}
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::string& temporaryName() const { return temporaryName_; }

  /// Writes bytes under the temporary name; false when they cannot be written.
  bool fill(const std::string& bytes) const;

  /// False when the file cannot be renamed.
  bool commit();

  /// Fills and commits.
  /// @return nothing, or what is wrong
  static std::string write(const std::string& name, const std::string& bytes);

  /// A hidden file of this program's own beside the one named, with the same ending in small letters.
  static std::string temporaryNameOf(const std::string& name);

  static constexpr const char* unwritable =
      "it cannot be written; give a file in a folder that exists and may be written to";

 private:
  std::string name_, temporaryName_;
};

}  // namespace mien
