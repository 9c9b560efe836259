#pragma once

#include <string>

#include "FaceState.h"

namespace CLI {
class App;
}

namespace mien {

class FacePipeline;

/// The options that describe a face, the same for all commands that need one: they fill a FaceState.
class FaceOptions {
 public:
  /// The options of the surface: the curves' file, the way between the curves, the uv mesh.
  void addSurfaceOptions(CLI::App& command);

  /// The options of the moment: FAP file and frame, and those of the movement.
  void addAnimationOptions(CLI::App& command);

  /// What moves the face in every frame: expressions, visemes and values set by hand, which add to those of the
  /// frames, and the tables of animation and deformation.
  void addMovementOptions(CLI::App& command);

  /// The options of the skin, for commands that draw.
  void addTextureOptions(CLI::App& command);

  void addAll(CLI::App& command);

  /// An animation file in place of --fap.
  void setAnimation(const std::string& file) { fap_ = file; }

  /// Expressions in place of --expression, in its form.
  void setExpressions(const std::string& expressions) { expression_ = expressions; }

  /// The resolution when none is given. Default: that of FaceState.
  void setDefaultResolution(int rows, int columns);

  /// Whether a resolution was given.
  bool hasResolution() const { return !resolution_.empty(); }

  /// What the options say. Throws a ValueFailure for text that is no value of its option.
  FaceState state() const;

  /// Gives the pipeline the state, reads the curves and checks the state against them: a FileFailure or a ValueFailure.
  void apply(FacePipeline& pipeline) const;

  /// A face to start from in place of the generic one; --face goes before it.
  void setDefaultFace(const std::string& file) { defaultFace_ = file; }

 private:
  FaceState start() const;
  std::string resolutionHelp() const;
  void fillSurface(FaceState& state) const;
  void fillGrid(FaceState& state) const;
  void fillFrame(FaceState& state) const;
  void fillMovement(FaceState& state) const;
  void fillTexture(FaceState& state) const;
  void fillDeformation(FaceState& state) const;

  int defaultRows_ = FaceState().rows, defaultColumns_ = FaceState().columns;
  std::string defaultFace_, face_, scheme_, smoothing_, harmonics_, resolution_, derivativeStrength_, precision_,
      state_;
  std::string fap_, frame_, index_, time_, expression_, viseme_, set_, animationTable_;
  std::string texture_, textureMesh_;
  std::string deformation_;
  bool hardRegions_ = false;
  bool noRemainder_ = false, uniformRows_ = false, interpolates_ = false;
};

/// Sets photograph and mesh from IMAGE, IMAGE:MESH.csv or "painted". Throws a ValueFailure or a FileFailure.
void setTexture(const std::string& text, FaceState& state);

/// Reads the curves and the animation file and checks the pipeline's state against them: a FileFailure or a
/// ValueFailure.
void checkOrThrow(FacePipeline& pipeline);

/// Brings the pipeline's surface up to date; what stops it is a FileFailure.
void updateOrThrow(FacePipeline& pipeline);

}  // namespace mien
