#include <cstdint>
#include <cstdlib>

#include "MarkerTable.h"
#include "Require.h"

using namespace mien;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  PointTable table, again;
  MarkerOptions options;
  options.yDown = size % 2;
  const std::string fault = table.parse(std::string(reinterpret_cast<const char*>(data), size), options);
  if (!fault.empty()) {
    require(std::atoi(fault.c_str()) >= 1 && table.points.empty());
    return 0;
  }
  for (const NamedPoint& point : table.points)
    require(!point.name.empty() && point.line > 1 && point.region >= 0 && point.region <= 16 &&
            point.position.allFinite());
  require(again.parse(table.write(options), options).empty() && again.points.size() == table.points.size());
  for (std::size_t i = 0; i < table.points.size(); ++i) {
    require(again.points[i].name == table.points[i].name && again.points[i].seen == table.points[i].seen);
    if (table.points[i].seen) require(again.points[i].position == table.points[i].position);
  }
  MarkerTable joined;
  if (joined.join(table, again, options).empty()) require(joined.neutral.unit() > 0.0 && !joined.markers.empty());
  return 0;
}
