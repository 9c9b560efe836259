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

  /// Only --regions, for commands that read no markers.
  void addRegionsTo(CLI::App& command);

  /// The same region map, all else as by default.
  MarkerFileOptions regionsOnly() const;

  /// Throws a ValueFailure when options were given that say how markers are read, and `file` has none but is a table.
  /// @param regions  whether the command has a use for --regions
  void refuseForTables(bool isRecording, const std::string& file, bool regions = true) const;

  /// Names or places of the pupils, direction of the axes. Throws a ValueFailure for text that is none.
  MarkerOptions markers() const;

  /// Throws a ValueFailure for pupils that were given without z, which those of a surface need.
  void requirePupilsInSpace() const;

  /// The user's region map or the one compiled in; a FileFailure for one that is wrong.
  FacialRegions regions() const;

  /// Says on stderr that places of pupils given once are taken for both states.
  void tellStillHead(const std::string& file) const;
  const std::string& regionFile() const { return regionFile_; }

  /// Whether axes are turned round, which meshes do not know.
  bool turnsAxes() const { return yDown_ || mirrored_; }

 private:
  bool yDown_ = false, mirrored_ = false;
  std::string pupils_, expressionPupils_, regionFile_;
};

/// What filters say of a surface, in this command line's words.
std::string surfaceFault(const std::string& fault);

/// The text of a file of markers or a table; a FileFailure when it cannot be read.
std::string readMarkerText(const std::string& file);

/// A recording of markers before and after, in which those that lie on pupils given by place do not count, which is
/// said on stderr; a FileFailure that names file and line.
MarkerTable readRecording(const std::string& file, const MarkerFileOptions& options);
MarkerTable parseRecording(const std::string& text, const std::string& file, const MarkerFileOptions& options);

/// Takes out of a recording the markers on pupils that were given by place, and says so on stderr.
void takeOutGivenPupils(MarkerTable& markers, const MarkerFileOptions& options, const std::string& file);

/// The markers of one state; a FileFailure that names file and line.
PointTable readPoints(const std::string& file, const MarkerFileOptions& options);

}  // namespace mien
