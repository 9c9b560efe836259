#pragma once

#include <array>
#include <string>
#include <vector>

#include "PointTable.h"
#include "PupilNormalisation.h"

namespace mien {

/// A marker before and after, in the file's own unit with y up and x to the subject's left.
struct Marker {
  std::string name;
  int line = 0;    ///< in the file, from 1
  int region = 0;  ///< 1 .. 16 where the file says so, else 0
  Eigen::Vector3d neutral = Eigen::Vector3d::Zero(), expression = Eigen::Vector3d::Zero();
};

/// The markers of one recording; those missing in either state are left out.
struct MarkerTable {
  std::vector<Marker> markers;       ///< without the pupils
  std::vector<std::string> missing;  ///< names of the markers with blank cells
  bool hasDepth = false;
  PupilNormalisation neutral, expression;

  /// CSV with a header naming `marker`, `neutral_x`, `neutral_y`, `expression_x`, `expression_y`, optionally
  /// `neutral_z` and `expression_z` (both or none) and `region`, in any order. Blank cells are markers that were not
  /// seen; the pupils must be. Lines that begin with # are comments. A face that stands on its head after normalisation
  /// or is the wrong way round is refused (describePosture).
  /// @return nothing, or "LINE: what is wrong and what to do" (" what ..": it is in no line); the table is then as it
  /// was
  std::string parse(const std::string& text, const MarkerOptions& options = {});

  /// From two files of the same markers, before and after, read with these options; a marker that one of them does not
  /// have was not seen. @return nothing, or "NAME:LINE: what is wrong", "NAME: .." or "NAME and NAME: .." with the
  /// names of the files
  std::string join(const PointTable& before, const PointTable& after, const MarkerOptions& options = {},
                   const std::array<std::string, 2>& names = {"neutral", "expression"});
};

}  // namespace mien
