#pragma once

#include <string>
#include <vector>

#include "Plate.h"

namespace mien {

/// A table of words and numbers, as it stands in a paper: no vertical rules, one under the heading.
struct TextTable {
  struct Column {
    std::string title;
    double share = 1.0;    ///< of the width, against the other columns
    bool numbers = false;  ///< set right, else left
  };
  /// A heading over several columns.
  struct Group {
    std::string title;
    int columns = 1;
  };
  std::vector<Group> groups;  ///< from the left over all columns; may be empty, titles too
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as columns; text is broken to fit
  double size = 6.5;                           ///< pt; smaller where words would be cut
  bool close = false;                          ///< little room between rows and columns
};

/// A panel that holds the table.
///
/// @param width  of the panel, mm: it decides where lines break, and so the height
PlatePanel tablePanel(const std::string& heading, const TextTable& table, double width);

}  // namespace mien
