#include <cstdint>
#include <cstdlib>

#include "MarkerTable.h"
#include "Require.h"

using namespace mien;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  MarkerTable table;
  table.missing = {"before"};
  MarkerOptions options;
  options.yDown = size % 2;
  const std::string fault = table.parse(std::string(reinterpret_cast<const char*>(data), size), options);
  if (!fault.empty()) {
    require(std::atoi(fault.c_str()) >= 1 && table.missing.size() == 1);
    return 0;
  }
  require(!table.markers.empty());
  for (const Marker& marker : table.markers) {
    require(!marker.name.empty() && marker.line > 1 && marker.region >= 0 && marker.region <= 16);
    require(marker.neutral.allFinite() && marker.expression.allFinite());
  }
  require(table.neutral.unit() > 0.0 && table.expression.unit() > 0.0);
  return 0;
}
