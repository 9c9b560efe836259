#pragma once

#include <string>

#include "SceneStyle.h"

namespace CLI {
class App;
}

namespace mien {

class FaceOptions;

/// The options of pictures, the same for all commands that draw a face.
class RenderOptions {
 public:
  static constexpr int largestSide = 8192;  ///< pixels; four times as much is what common drivers can hold

  explicit RenderOptions(const std::string& defaultSize) : size_(defaultSize) {}

  void addTo(CLI::App& command);

  /// Gives the face the resolution that suits the style, for when the user asks for none: 164 rows have every curve
  /// among them and leave no facet to be seen; lines are drawn at the usual resolution.
  void chooseResolution(FaceOptions& face) const;

  /// Throws a ValueFailure for what is no value of its option.
  SceneStyle style() const;

 private:
  std::string view_ = "front", size_, background_ = "white", colorBy_, style_ = "shaded", zoom_ = "neutral";
  bool transparent_ = false, curves_ = false;
};

}  // namespace mien
