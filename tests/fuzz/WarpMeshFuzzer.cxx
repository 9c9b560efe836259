#include <cstdint>
#include <cstdlib>

#include "Require.h"
#include "WarpMeshText.h"

using namespace mien;

/// A refusal names a line and leaves the mesh alone; what is accepted is sound and comes back from writeWarpMesh.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  WarpMesh mesh = evenMesh(2, 2, 3, 3), again;
  const std::string fault = parseWarpMesh(std::string(reinterpret_cast<const char*>(data), size), mesh);
  if (!fault.empty()) {
    require(std::atoi(fault.c_str()) >= 1 && fault.size() < 400 && mesh == evenMesh(2, 2, 3, 3));
    return 0;
  }
  require(describeFault(mesh, "the mesh").empty());
  for (std::string& name : mesh.names) name.clear();  // names may hold what CSV does not keep
  require(parseWarpMesh(writeWarpMesh(mesh), again).empty());
  require(again == mesh);
  return 0;
}
