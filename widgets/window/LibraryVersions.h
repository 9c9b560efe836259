#pragma once

#include <QString>
#include <utility>
#include <vector>

namespace mien {

/// What Mien's programs are made of and run on, with the version of each: Mien, every library that README's table of
/// dependencies names for them, under its name there, OpenGL and the system.
std::vector<std::pair<QString, QString>> libraryVersions();

}  // namespace mien
