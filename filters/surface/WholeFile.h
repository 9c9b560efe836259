#pragma once

#include <string>
#include <system_error>

#include "MienSurfaceModule.h"

namespace mien {

/// A file that appears only when it is complete: it is written under a temporary name beside its own, and commit()
/// renames it. What was there before is replaced whole or not at all, and keeps its permissions; of a symbolic link
/// that is the file it leads to.
class MIENSURFACE_EXPORT WholeFile {
 public:
  explicit WholeFile(const std::string& name) : name_(targetOf(name)), temporaryName_(temporaryNameOf(name_)) {}
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  const std::string& temporaryName() const { return temporaryName_; }

  /// Writes bytes under the temporary name; false when they cannot be written.
  bool fill(const std::string& bytes) const;

  /// False when the disk is full, or the file cannot be renamed.
  bool commit();

  /// Fills and commits.
  /// @return nothing, or what is wrong
  static std::string write(const std::string& name, const std::string& bytes);

  /// The file itself, or what the symbolic link of that name leads to.
  static std::string targetOf(const std::string& name);

  /// Puts the temporary file in the place of the other, with whose permissions it leaves, if there is one.
  /// Not where the disk is full: what a writer left there need not be all that it wrote.
  static std::error_code replace(const std::string& name, const std::string& temporaryName);

  /// A hidden file of this program's own beside the one named, with the same ending in small letters.
  static std::string temporaryNameOf(const std::string& name);

  static constexpr const char* unwritable =
      "it cannot be written; give a file in a folder that exists, may be written to and has space left";

 private:
  std::string name_, temporaryName_;
};

}  // namespace mien
