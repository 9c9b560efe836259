#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "FaceCurves.h"
#include "MotionField.h"
#include "PicturePlane.h"

namespace mien {

/// Part of a face whose motion is looked at; nothing set: all of it.
struct VectorRegion {
  std::string name;                              ///< as it was asked for
  std::optional<int> patch;                      ///< 0 .. 8
  std::optional<Eigen::AlignedBox3d> box;        ///< around feature points, mm
  std::optional<Eigen::AlignedBox2d> rectangle;  ///< in the picture: to the right, up; mm

  bool isWhole() const { return !patch && !box && !rectangle; }
  bool contains(const MotionField& field, int index, const PicturePlane& plane) const;

  /// "P0" .. "P8", "mouth", "eyes", "brows", "nose", "cheeks", "chin", or XMIN,YMIN,XMAX,YMAX in mm.
  /// @param face  with the feature points that the names need, or nullptr
  /// @return nothing, or one sentence that says what is wrong; the region is then as it was
  std::string parse(const std::string& text, const FaceCurves* face);

  /// "mouth, eyes, ..": the names that parse() knows.
  static std::string names();
};

}  // namespace mien
