#include <cstdint>
#include <cstdlib>
#include <string>

#include "MeshText.h"

using namespace mien;

/// Any bytes are read as a sound mesh or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const char* const ending : {".ply", ".off", ".obj", ".stl"}) {
    MeshText read;
    const auto fault = readMeshText(text, ending, read);
    const bool isEmpty = read.mesh.vertices.rows() == 0 && read.mesh.triangles.rows() == 0;
    if (fault && (fault->line < 0 || fault->message.empty() || !isEmpty)) std::abort();
    if (read.mesh.triangles.rows() == 0) continue;
    if (!read.mesh.vertices.allFinite() || read.mesh.triangles.minCoeff() < 0) std::abort();
    if (read.mesh.triangles.maxCoeff() >= read.mesh.vertices.rows() || read.polygons.sum() == 0) std::abort();
  }
  return 0;
}
