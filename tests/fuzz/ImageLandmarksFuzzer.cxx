#include <cstdint>
#include <cstdlib>

#include "ImageLandmarks.h"

using namespace mien;

/// A refusal names a line and leaves the landmarks alone; what is accepted is finite.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ImageLandmarks landmarks;
  const std::string fault = parseImageLandmarks(std::string(reinterpret_cast<const char*>(data), size), landmarks);
  if (fault.empty() == landmarks.empty()) std::abort();
  if (!fault.empty() && (std::atoi(fault.c_str()) < 1 || fault.size() > 400)) std::abort();
  for (const auto& [name, point] : landmarks)
    if (name.empty() || !point.allFinite()) std::abort();
  return 0;
}
