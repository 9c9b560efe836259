#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "TableText.h"

using namespace mien;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  DeformationTable table, again;
  table.largestDisplacement = 0.25;
  const std::string fault = parseTable(std::string(reinterpret_cast<const char*>(data), size), table);
  if (!fault.empty()) {
    require(std::atoi(fault.c_str()) >= 1 && table.largestDisplacement == 0.25);
    return 0;
  }
  for (const QuadraticMap& map : table.maps) require(map.coefficients.allFinite());
  require(parseTable(writeTable(table), again).empty());
  for (int i = 0; i < DeformationTable::regionCount; ++i)
    require(again.maps[i].coefficients == table.maps[i].coefficients);
  require(again.deviations.has_value() == table.deviations.has_value());
  return 0;
}
