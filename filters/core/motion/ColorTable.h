#pragma once

#include <array>
#include <string>
#include <vector>

namespace mien {

/// A perceptually uniform colour map: equal steps of a value look equally large, in order without colour vision too.
struct ColorTable {
  using Rgb = std::array<double, 3>;  ///< 0 .. 1, sRGB

  std::string name;
  const std::array<int, 52>* samples;  ///< 0xrrggbb at t = 0, 1/51 .. 1
  bool diverging = false;              ///< palest in the middle, for values on both sides of zero

  /// Between the samples linear; t below 0 or above 1 has the end's colour.
  Rgb at(double t) const;

  /// viridis, cividis, magma, inferno, plasma; coolwarm, which diverges from blue over grey to red.
  static const std::vector<ColorTable>& all();

  /// The table of that name, or nullptr.
  static const ColorTable* find(const std::string& name);
};

}  // namespace mien
