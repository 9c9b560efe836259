#pragma once

#include <optional>
#include <string_view>

#include "FAPFrame.h"

namespace mien {

/// A column of a table that holds one number of a FAP frame.
struct FAPColumn {
  int fap = 0;     ///< 1 .. 68
  int field = -1;  ///< for FAP 1 and 2, in the order of FAPFields.h; else -1

  void setValue(FAPFrame& frame, double value) const;
};

/// "FAP51", "fap 51", "FAP51_lower_t_midlip_o" or "lower_t_midlip_o" (the names of FAPTable.h); for FAP 1 and 2 the
/// names of FAPFields.h, with or without "FAP1_" and "FAP2_". Where number and name disagree the number counts.
std::optional<FAPColumn> findFAPColumn(std::string_view name);

}  // namespace mien
