#pragma once

#include <string>

#include "FigureOptions.h"
#include "MotionVectorOptions.h"

namespace CLI {
class App;
}

namespace mien {

/// The options that say how motion vectors are drawn.
class VectorDrawing {
 public:
  void addTo(CLI::App& command);

  /// Before anything is computed: throws a ValueFailure for a wrong value.
  void check() const;

  /// View, sampling, scale and so on; the region is left to chooseRegion().
  MotionVectorOptions options() const;

  /// @param face  with feature points, or nullptr. Throws a ValueFailure.
  void chooseRegion(const FaceCurves* face, MotionVectorOptions& options) const;

  /// Whether the figure is to be without title, caption and note.
  bool isBare() const { return bare_; }

  const FigureOptions& file() const { return file_; }
  const std::string& view() const { return view_; }

  /// The view in words: "front", "azimuth 30\u00b0, elevation 10\u00b0".
  std::string viewName() const;

 private:
  void fillPicture(MotionVectorOptions& options) const;
  void fillScale(MotionVectorOptions& options) const;
  void fillRange(MotionVectorOptions& options) const;
  void fillColors(MotionVectorOptions& options) const;

  FigureOptions file_{"85"};
  std::string view_ = "front", region_, sample_ = "auto", scale_ = "auto", range_, length_ = "seen";
  std::string color_ = "space", colorMap_ = "auto", columns_;
  bool wholeFace_ = false, hidden_ = false, noSeams_ = false, bare_ = false;
};

}  // namespace mien
