#include "LengthUnit.h"

namespace mien {

const std::vector<LengthUnit>& lengthUnits() {
  static const std::vector<LengthUnit> units = {
      {"mm", "millimetres", 1.0}, {"cm", "centimetres", 10.0}, {"m", "metres", 1000.0}, {"inch", "inches", 25.4}};
  return units;
}

const LengthUnit* lengthUnit(const std::string& name) {
  for (const LengthUnit& unit : lengthUnits())
    if (unit.name == (name == "in" ? "inch" : name)) return &unit;
  return nullptr;
}

std::vector<LengthUnit> unitsThatFit(double length, double low, double high) {
  std::vector<LengthUnit> fitting;
  for (const LengthUnit& unit : lengthUnits())
    if (length * unit.millimetres >= low && length * unit.millimetres <= high) fitting.push_back(unit);
  return fitting;
}

}  // namespace mien
