#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "PackedTable.h"
#include "Require.h"
#include "TableText.h"

using namespace mien;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  if (isPackedTable(bytes)) {
    DeformationTable packed;
    packed.largestDisplacement = 0.25;
    if (!unpackTable(bytes, packed).empty()) require(packed.largestDisplacement == 0.25);
    for (const QuadraticMap& map : packed.maps) require(map.coefficients.allFinite());
    return 0;
  }
  DeformationTable table, again;
  table.largestDisplacement = 0.25;
  const std::string fault = parseTable(bytes, table);
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
