#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

namespace mien {

/// Named points on a picture of a face, in pixels from its upper left corner, y down. "0" .. "67" are the landmarks of
/// Multi-PIE, numbered as in FaceLandmarks; the 25 points of the warp mesh have the names of their places
/// (FaceWarpLayout).
using ImageLandmarks = std::map<std::string, Eigen::Vector2d>;

/// CSV with a header naming `landmark` (number or name), `x` and `y`, in any order. Lines that begin with # are
/// comments.
/// @return nothing, or "LINE: what is wrong and what to do"; the landmarks are then as they were
std::string parseImageLandmarks(const std::string& text, ImageLandmarks& landmarks);

}  // namespace mien
