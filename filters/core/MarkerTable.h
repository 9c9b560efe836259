#pragma once

#include "PupilNormalisation.h"

#include <string>
#include <vector>

namespace mien {

/// How a marker file is to be read.
struct MarkerOptions {
  bool yDown = false;     ///< y grows downwards, as in images
  bool mirrored = false;  ///< the pictures show the face as a mirror does: x is turned round
  std::string leftPupil = "pupil_left";  ///< name of the marker on the subject's left pupil
  std::string rightPupil = "pupil_right";
};

/// A marker before and after, in the file's own unit with y up and x to the subject's left.
struct Marker {
  std::string name;
  int line = 0;    ///< in the file, from 1
  int region = 0;  ///< 1 .. 16 where the file says so, else 0
  Eigen::Vector3d neutral = Eigen::Vector3d::Zero(), expression = Eigen::Vector3d::Zero();
};

/// The markers of one recording; those missing in either state are left out.
struct MarkerTable {
  std::vector<Marker> markers;     ///< without the pupils
  std::vector<std::string> missing;  ///< names of the markers with blank cells
  bool hasDepth = false;
  PupilNormalisation neutral, expression;

  /// CSV with a header naming `marker`, `neutral_x`, `neutral_y`, `expression_x`, `expression_y`, optionally `neutral_z` and
  /// `expression_z` (both or none) and `region`, in any order. Blank cells are markers that were not seen; the pupils must be.
  /// A face that stands on its head after normalisation is refused.
  /// @return nothing, or "LINE: what is wrong and what to do"; the table is then as it was
  std::string parse(const std::string& text, const MarkerOptions& options = {});
};

}  // namespace mien
