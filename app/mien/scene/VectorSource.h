#pragma once

#include <memory>
#include <string>
#include <vector>

#include "FaceCurves.h"
#include "FaceOptions.h"
#include "FaceState.h"
#include "MotionField.h"
#include "MotionWords.h"
#include "PicturePlane.h"
#include "vtkSmartPointer.h"

namespace CLI {
class App;
}

class vtkCellArray;
class vtkPointSet;
class vtkPolyData;

namespace mien {

class FaceMotion;

/// One motion field of a series.
struct VectorMoment {
  std::string frame;  ///< number as written in the .fap file; empty for what is no frame
  FaceState state;    ///< of the moved face
  MotionField field;
  vtkSmartPointer<vtkPolyData> vectors;  ///< as vtkMotionVectorFilter makes them
};

/// The options that say what moves, and from where: a face in some state or frames of an animation, or a surface file,
/// against the neutral face, a frame or another surface file.
class VectorSource {
 public:
  VectorSource();
  ~VectorSource();

  void addTo(CLI::App& command);

  /// Reads and computes all fields; throws a FileFailure or a ValueFailure.
  std::vector<VectorMoment> moments(const PicturePlane& plane);

  /// Feature points where the vectors start; nullptr for surfaces that are no face. After moments().
  const FaceCurves* face() const;

  bool isSeries() const { return !frames_.empty(); }
  bool headMotionRemoved() const { return removeHeadMotion_; }
  const std::string& against() const { return against_; }

  /// What the figure shows; the view is left open. After moments().
  MotionWords words() const;

 private:
  enum class Against { Neutral, Previous, Frame, Mesh };
  void check() const;
  Against kind() const;
  std::vector<FaceState> states();
  VectorMoment faceMoment(const FaceState& state);
  VectorMoment againstMesh(const FaceState& state, const PicturePlane& plane);
  vtkSmartPointer<vtkPointSet> movedLike(vtkPointSet* origin);
  void refuseFaceOptions() const;
  std::string originName() const;
  std::string framesName() const;
  VectorMoment meshMoment(vtkPointSet* moved, const std::string& name, const PicturePlane& plane) const;
  FaceState originOf(const FaceState& state);
  std::string frameText(const FaceState& state) const;

  FaceOptions options_;
  std::string surface_, against_ = "neutral", frames_;
  bool removeHeadMotion_ = false;
  const CLI::App* command_ = nullptr;
  std::unique_ptr<FaceMotion> motion_;
  vtkSmartPointer<vtkPointSet> origin_;  ///< the surface file that the vectors start from, once read
  vtkSmartPointer<vtkCellArray> cut_;    ///< its polygons when they cut up those of the face
  std::vector<std::string> moved_;       ///< frames, as written in the .fap file
  bool hasFace_ = false;
};

}  // namespace mien
