#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "EyePupils.h"

namespace mien {

/// How a file of markers is to be read.
struct MarkerOptions {
  bool yDown = false;                    ///< y grows downwards, as in images
  bool mirrored = false;                 ///< the pictures show the face as a mirror does: x is turned round
  std::string leftPupil = "pupil_left";  ///< name of the marker on the subject's left pupil
  std::string rightPupil = "pupil_right";
  std::optional<EyePupils> neutralPupils, expressionPupils;  ///< by place, as the file counts x and y; before names

  /// A point of the file with y up and x to the subject's left; its own inverse.
  Eigen::Vector3d upright(const Eigen::Vector3d& point) const {
    return {mirrored ? -point.x() : point.x(), yDown ? -point.y() : point.y(), point.z()};
  }
};

/// A marker of one state of a face, in the file's own unit, with y up and x to the subject's left.
struct NamedPoint {
  std::string name;
  int line = 0;       ///< in the file, from 1
  int region = 0;     ///< 1 .. 16 where the file says so, else 0
  bool seen = false;  ///< false: blank cells
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The markers of one state of a face.
struct PointTable {
  std::vector<NamedPoint> points;  ///< all, pupils too, in the file's order
  bool hasDepth = false;
  bool hasRegions = false;

  /// CSV with a header naming `marker`, `x`, `y`, optionally `z` and `region`, in any order. Blank cells are markers
  /// that were not seen, lines that begin with # comments. @return nothing, or "LINE: what is wrong and what to do";
  /// the table is then as it was
  std::string parse(const std::string& text, const MarkerOptions& options = {});

  /// The text that parse() reads back without a difference, with these options.
  std::string write(const MarkerOptions& options = {}) const;

  const NamedPoint* find(const std::string& name) const;

  /// The pupils by place or by name, y up. @return nothing, or "LINE: what is missing"
  std::string findPupils(const MarkerOptions& options, EyePupils& pupils) const;
};

/// The region in a cell: 1 .. 16, 0 for a blank one, nothing for any other text.
std::optional<int> parseRegion(const std::string& cell);

/// Names of markers and where they are, pupil units.
using MarkerPlaces = std::vector<std::pair<std::string, Eigen::Vector2d>>;

/// What is wrong with a face that hangs upside down or is the wrong way round, or nothing. A chin (landmark 8) tells
/// the one, landmarks of either side of the face the other. Without a chin so does, of a whole face, the mean height of
/// 16 markers or more, which lies below the pupils; some markers may be of the forehead alone.
std::string describePosture(const MarkerPlaces& places, bool wholeFace);

}  // namespace mien
