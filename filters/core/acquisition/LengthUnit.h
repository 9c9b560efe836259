#pragma once

#include <string>
#include <vector>

namespace mien {

/// A unit that lengths of scans may be in.
struct LengthUnit {
  std::string name;      ///< as options take it: "mm", "cm", "m", "inch"
  std::string fullName;  ///< "millimetres" ..
  double millimetres;    ///< of one
};

/// mm, cm, m and inch.
const std::vector<LengthUnit>& lengthUnits();

/// By name ("in" is understood as inch), or nullptr.
const LengthUnit* lengthUnit(const std::string& name);

/// The units in which a length lies between two bounds (mm).
std::vector<LengthUnit> unitsThatFit(double length, double low, double high);

/// Distance of the outer eye corners of people of any age, mm. The bounds lie closer than a factor of 2.54, so that no
/// two units fit.
constexpr double smallestEyeDistance = 60.0, largestEyeDistance = 140.0;

}  // namespace mien
