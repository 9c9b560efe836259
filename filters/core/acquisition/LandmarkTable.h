#pragma once

#include <array>
#include <string>

#include "FaceLandmarks.h"
#include "TriangleMesh.h"

namespace mien {

/// Landmarks as a file gives them: by vertex number, by position, or by both.
///
/// CSV with a header line naming the columns `vertex` (from 0), or `x`, `y`, `z` (in the scan's unit), or all of them,
/// in any order, and `landmark`: a number 0 .. 67 or a name (landmarkName). Without that column the rows are landmarks
/// 0, 1, 2 .. With a vertex column positions come from the mesh, so that one file serves every mesh of its topology.
/// The twelve landmarks with names must be there; others may be left out and are completed from the generic face.
struct LandmarkTable {
  using Given = std::array<bool, FaceLandmarks::count>;

  bool hasVertices = false;
  std::array<long, FaceLandmarks::count> vertices{};
  FaceLandmarks positions;  ///< zero when the file has vertices only, and where a landmark is not given
  Given given{};
};

/// Parses the text of a landmark file.
/// @return nothing, or "LINE: what is wrong and what to do"
std::string parseLandmarks(const std::string& text, LandmarkTable& table);

/// Parses landmarks of a picture: as above with the columns `x` and `y` alone (z is 0), and all 68 of them. The header
/// may be missing where the rows are `landmark,x,y`, or `x,y` in the order of the landmarks.
/// @return nothing, or "LINE: what is wrong and what to do"
std::string parsePictureLandmarks(const std::string& text, FaceLandmarks& landmarks);

/// The name of one of the twelve landmarks that every file must have ("nose_tip"), or "" of another.
std::string landmarkName(int landmark);

/// The landmarks on a mesh; those that are not given are zero.
/// @return nothing, or one sentence that names the landmark whose vertex the mesh does not have
std::string placeLandmarks(const LandmarkTable& table, const TriangleMesh& mesh, FaceLandmarks& landmarks);

/// Places the landmarks that were not given by the smooth warp that takes those of a reference face to the given ones;
/// any pose and unit.
/// @return nothing, or one sentence when the given ones lie in a plane or at one place
std::string completeLandmarks(const FaceLandmarks& reference, const LandmarkTable::Given& given,
                              FaceLandmarks& landmarks);

/// The text of a landmark file with the columns landmark, x, y, z; numbers read back to the bit.
std::string landmarkText(const FaceLandmarks& landmarks);

}  // namespace mien
