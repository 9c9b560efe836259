#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace mien {

/// What is wrong with how a mesh lies about its pupils, or nothing: the skin at the eyes more than 1.5 pupil units in
/// front of or behind the pupils, as when the back of the head looks along +z or the pupils' depth is wrong. Meshes
/// without points there are not judged.
/// @param places  of the mesh's points, pupil units
std::string describeFront(const std::vector<Eigen::Vector3d>& places);

}  // namespace mien
