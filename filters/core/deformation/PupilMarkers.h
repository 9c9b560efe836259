#pragma once

#include <string>
#include <vector>

#include "MarkerTable.h"

namespace mien {

/// Whether a point lies on a pupil as the normalisation knows it: within 0.02 pupil units, a rounded coordinate.
bool liesOnPupil(const PupilNormalisation& pupils, const Eigen::Vector3d& point);

/// Takes out the markers that lie on a pupil before the movement: normalisation holds pupils still, so that they would
/// say of the eyes' skin that it does not move. Pupils that are found by name are no markers anyway.
/// @return their names
std::vector<std::string> takeOutPupils(MarkerTable& table);

}  // namespace mien
