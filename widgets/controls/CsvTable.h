#pragma once

#include <string>

class vtkTable;

namespace mien {

/// A table as CSV: a line of column names, then its rows; numbers to 10 digits, texts with commas in quotes, NaN as
/// "nan".
std::string tableText(vtkTable* table);

}  // namespace mien
