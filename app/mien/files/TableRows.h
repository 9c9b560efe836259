#pragma once

#include <nlohmann/json.hpp>
#include <string>

class vtkTable;

namespace mien {

/// The rows of a table, each an object of column name and value; what is not finite becomes null.
nlohmann::ordered_json tableRows(vtkTable* table);

/// "name,name" and a line per row; null is empty. All rows have the keys of the first.
std::string csvText(const nlohmann::ordered_json& rows);

/// The same for reading: columns below each other, numbers in four digits; null is "-".
std::string readableText(const nlohmann::ordered_json& rows);

/// A number in four digits.
std::string readableNumber(double value);

}  // namespace mien
