#pragma once

#include <string>

class vtkPolyData;

namespace CLI {
class App;
}

namespace mien {

/// The options of commands that can write a compact face file (.mienz), and the writing.
class CompactFaceOutput {
 public:
  void addTo(CLI::App& command);

  /// Throws a ValueFailure for a tolerance that is none, and for options of another kind of file.
  void check(const std::string& fileName) const;

  /// Writes boundary curves, and says on stderr what was left out; a FileFailure or a ValueFailure when they cannot be.
  void write(vtkPolyData* curves, const std::string& fileName) const;

 private:
  double tolerance() const;

  const CLI::App* command_ = nullptr;
  std::string tolerance_ = "0.1mm", faceName_;
};

}  // namespace mien
