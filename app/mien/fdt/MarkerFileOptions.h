#pragma once

#include <string>

#include "FacialRegions.h"
#include "MarkerTable.h"

namespace CLI {
class App;
}

namespace mien {

/// The options of how marker files and faces are read, the same for all commands that take them.
class MarkerFileOptions {
 public:
  /// @param twoStates  whether the pupils of a second state can be given
  void addTo(CLI::App& command, bool twoStates);

  /// Names or places of the pupils, direction of the axes. Throws a ValueFailure for text that is none.
  MarkerOptions markers() const;

  /// The user's region map or the one compiled in; a FileFailure for one that is wrong.
  FacialRegions regions() const;
  const std::string& regionFile() const { return regionFile_; }

  /// Whether axes are turned round, which meshes do not know.
  bool turnsAxes() const { return yDown_ || mirrored_; }

 private:
  bool yDown_ = false, mirrored_ = false;
  std::string pupils_, expressionPupils_, regionFile_;
};

/// The text of a file of markers or a table; a FileFailure when it cannot be read.
std::string readMarkerText(const std::string& file);

/// A recording of markers before and after; a FileFailure that names file and line.
MarkerTable readRecording(const std::string& file, const MarkerFileOptions& options);

/// The markers of one state; a FileFailure that names file and line.
PointTable readPoints(const std::string& file, const MarkerFileOptions& options);

}  // namespace mien
