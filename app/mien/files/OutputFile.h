#pragma once

#include <string>
#include <vector>

namespace mien {

/// The ending of a file name in small letters, without the dot; "" when there is none.
std::string fileEnding(const std::string& name);

/// Throws a ValueFailure that lists the known endings when the file has another.
void requireEnding(const std::string& name, const std::vector<std::string>& known);

/// A file that exists only when it is complete: it is written under a temporary name in the same folder, and commit()
/// gives it its own. Without commit() nothing stays and what was there before is untouched.
class OutputFile {
 public:
  /// Throws a FileFailure when the folder cannot be written to or the name is that of a folder.
  explicit OutputFile(const std::string& name);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& name() const { return name_; }
  const std::string& temporaryName() const { return temporaryName_; }  ///< ends as the name does, in small letters

  /// Throws a FileFailure when nothing was written or the file cannot be renamed.
  void commit();

  /// For text that is at hand: writes and commits it.
  static void write(const std::string& name, const std::string& text);

 private:
  std::string name_;
  std::string temporaryName_;
};

}  // namespace mien
