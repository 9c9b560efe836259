#pragma once

#include <QString>
#include <utility>
#include <vector>

namespace mien {

/// What this program is made of and runs on, with the version of each: Mien, VTK, Qt, Eigen, OpenMesh, JSON, OpenGL and
/// the system.
std::vector<std::pair<QString, QString>> libraryVersions();

}  // namespace mien
