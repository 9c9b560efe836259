#include <cstdint>
#include <cstdlib>
#include <string>

#include "MeshTextFault.h"
#include "PolygonCounts.h"
#include "ScanHeader.h"

using namespace mien;

/// Any bytes are judged and walked through without a fault, and what fits into a file fits into a larger one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string start(reinterpret_cast<const char*>(data), size);
  for (const char* const ending : {".ply", ".off", ".stl", ".obj"})
    if (!promisesTooMuch(start, ending, size) && promisesTooMuch(start, ending, 2 * size + 1)) std::abort();
  for (const char* const ending : {".ply", ".off", ".obj", ".stl"}) {
    describeMeshTextFault(start, ending);
    countPolygons(start, ending);
  }
  return 0;
}
