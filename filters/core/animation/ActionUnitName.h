#pragma once

#include <optional>
#include <string_view>

namespace mien {

/// The name of a column of FACS data: "AU1", "AU01", "AU2L", "AU02_R", "L_AU1", and as OpenFace writes them "AU01_r"
/// (0 .. 5) and "AU01_c" (0 or 1).
struct ActionUnitName {
  enum class Kind { Plain, Intensity, Presence };
  enum class Side { Both, Left, Right };

  int unit = 0;
  Kind kind = Kind::Plain;
  Side side = Side::Both;
};

/// @param sidesAreSmall whether "_l" and "_r" are sides, as in a table that has both, and not OpenFace's intensity
std::optional<ActionUnitName> parseActionUnitName(std::string_view text, bool sidesAreSmall);

}  // namespace mien
