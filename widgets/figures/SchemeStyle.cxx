#include "SchemeStyle.h"

#include "FaceScheme.h"

namespace mien {

int schemeStyle(const std::string& scheme) {
  int style = 0;
  for (const FaceScheme& known : faceSchemes()) {
    if (known.name == scheme) return style;
    ++style;
  }
  return 0;
}

}  // namespace mien
