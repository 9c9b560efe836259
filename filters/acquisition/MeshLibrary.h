#pragma once

#include <string>

#include "MienAcquisitionModule.h"

namespace mien {

/// The version of the library that decimates meshes, OpenMesh: "9.0".
MIENACQUISITION_EXPORT std::string meshLibraryVersion();

}  // namespace mien
