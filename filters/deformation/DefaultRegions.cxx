#include "DefaultRegions.h"

#include "RegionsFile.h"

namespace mien {

const FacialRegions& defaultRegions() {
  static const FacialRegions regions = [] {
    FacialRegions parsed;
    parsed.parse(RegionsFile());
    return parsed;
  }();
  return regions;
}

}  // namespace mien
