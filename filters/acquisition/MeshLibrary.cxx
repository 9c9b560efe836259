#include "MeshLibrary.h"

#include <OpenMesh/Core/System/config.h>

namespace mien {

std::string meshLibraryVersion() {
  return std::to_string(OM_GET_VER) + '.' + std::to_string(OM_GET_MAJ);
}

}  // namespace mien
