#pragma once

#include <array>
#include <memory>
#include <vector>

class vtkPolyData;

namespace mien {

class FacePipeline;
struct FaceState;
struct FAPSequence;

/// How far the face reaches while it moves: what a view must hold for all of an animation to be seen.
class MotionReach {
 public:
  using Point = std::array<double, 3>;  ///< mm

  MotionReach();
  ~MotionReach();

  /// Begins anew: with the neutral face, and the frames in which a FAP is at one of its ends.
  /// @param motion  visemes and expressions turned into FAPs
  void plan(const FaceState& face, const FAPSequence& motion);

  /// Adds what a pipeline shows now. @return whether that lies beyond what was known
  bool add(const FacePipeline& shown);

  bool hasGrown() const { return grown_; }  ///< by add() since plan()

  /// How far a point of the curves moves in the frames of the last plan(), in mm.
  /// @param withHead  whether the turns of the head count
  double movement(bool withHead) const { return movement_[withHead]; }

  /// The points that reach furthest to the front, the sides and the diagonals between them.
  const std::vector<Point>& points() const { return points_; }

 private:
  bool take(vtkPolyData* curves);

  std::unique_ptr<FacePipeline> probe_;
  std::vector<Point> points_;
  std::vector<double> reach_;
  std::array<double, 2> movement_ = {};  ///< without the turns of the head, and with them
  bool grown_ = false;
};

}  // namespace mien
