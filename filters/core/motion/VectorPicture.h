#pragma once

#include <vector>

#include "MotionField.h"
#include "PicturePlane.h"
#include "VectorRegion.h"
#include "VectorSampling.h"

namespace mien {

/// Which vectors of a field are seen, and from where.
struct VectorPictureOptions {
  PicturePlane plane;
  VectorRegion region;
  VectorSampling sampling;
  Eigen::Vector2d paper = {80.0, 120.0};  ///< mm, the room of the picture in print, for automatic sampling
  bool hidden = false;                    ///< whether what the surface hides is drawn too
  bool wholeFrame = false;                ///< whether a region is shown within the whole surface
  bool lines = true;                      ///< outline, seams and landmarks; finding them is most of the work
};

/// One vector in the picture, mm on the face.
struct PictureArrow {
  Eigen::Vector2d tail, vector;  ///< to the right, up
  double magnitude = 0.0;        ///< length in space
  double towards = 0.0;          ///< component towards the viewer
  int index = 0;                 ///< of the vector in the field
};

/// A motion field in orthogonal projection: what is drawn where, mm on the face.
struct VectorPicture {
  using Line = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  std::vector<PictureArrow> arrows;  ///< those that move, the smallest first
  std::vector<int> chosen;           ///< vectors of the region that are seen and sampled, moving or not; ascending
  int still = 0;                     ///< vectors that were chosen but do not move
  VectorSampling sampling;           ///< as it was done; never automatic
  std::vector<Line> outline, seams;  ///< parts that are seen
  std::vector<Line> landmarks;       ///< lids, brows, nose and lips, parts that are seen
  Eigen::AlignedBox2d frame;         ///< what the picture shows
  Eigen::AlignedBox2d tails;         ///< around the origins in the region

  double longest() const;  ///< in the picture, mm; 0 without arrows
  double largest() const;  ///< in space, mm; 0 without arrows
};

/// A motion of less (mm) is none: rounding of points in single precision after a turned head is 1e-5 mm.
constexpr double leastMotion = 1e-4;

/// Distance in print between arrows of automatic sampling, mm.
constexpr double printedSpacing = 2.4;

/// Projects, samples and scales a motion field for a picture.
VectorPicture drawnVectors(const MotionField& field, const VectorPictureOptions& options);

}  // namespace mien
