#pragma once

#include <memory>
#include <string>

#include "FaceCurves.h"
#include "FaceState.h"
#include "MienAnimationModule.h"
#include "MotionField.h"
#include "PicturePlane.h"

class vtkPolyData;
class vtkPointSet;

namespace mien {

class FacePipeline;

/// The motion of a face from one state to another: two pipelines, vtkMotionVectorFilter between them, and the face on a
/// grid fine enough to be drawn under the vectors.
///
/// Both states have the moved one's resolution and double precision. Errors are kept, not printed: update() returns
/// them.
class MIENANIMATION_EXPORT FaceMotion {
 public:
  FaceMotion();
  ~FaceMotion();
  FaceMotion(const FaceMotion&) = delete;
  FaceMotion& operator=(const FaceMotion&) = delete;

  /// Where the points are, and where they come from. They can be given to the pipelines before, to check them.
  void setStates(const FaceState& moved, const FaceState& origin);

  /// The face without FAPs, expressions, visemes, frame or deformation.
  static FaceState neutralOf(const FaceState& state);

  FacePipeline& moved();
  FacePipeline& origin();

  /// Whether FAPs 48 to 50 count as motion. Default: they do.
  void setHeadMotionRemoved(bool removed);

  /// For the projected arrays of vectors(). Default: the front.
  void setPlane(const PicturePlane& plane);

  /// Brings everything up to date; the first error on the way as one sentence, or nothing.
  std::string update();

  vtkPolyData* vectors() const;  ///< as vtkMotionVectorFilter makes them
  const MotionField& field() const;

  /// The curves that the vectors start on, with their feature points.
  const FaceCurves& originFace() const;

 private:
  struct Internals;
  std::unique_ptr<Internals> Impl;
};

}  // namespace mien
