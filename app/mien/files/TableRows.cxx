#include "TableRows.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "CsvText.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

json valueOf(const vtkVariant& cell) {
  if (cell.IsString()) return std::string(cell.ToString());
  if (!cell.IsFloat() && !cell.IsDouble()) return cell.ToLongLong();
  const double value = cell.ToDouble();
  return std::isfinite(value) ? json(value) : json(nullptr);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
  return result + "\"";
}

std::string csvCell(const json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return quoted(value);
  return value.is_number_float() ? shortestText(value) : value.dump();
}

std::string readableCell(const json& value) {
  if (value.is_null()) return "-";
  if (value.is_string()) return value.get<std::string>().empty() ? "-" : value.get<std::string>();
  if (!value.is_number_float()) return value.dump();
  return readableNumber(value);
}

using Lines = std::vector<std::vector<std::string>>;

Lines readableCells(const json& rows) {
  Lines lines(1);
  for (const auto& item : rows.front().items()) lines[0].push_back(item.key());
  for (const json& row : rows) {
    lines.emplace_back();
    for (const auto& item : row.items()) lines.back().push_back(readableCell(item.value()));
  }
  return lines;
}

std::string padded(const std::string& text, size_t width, bool left) {
  const std::string blanks(width > text.size() ? width - text.size() : 0, ' ');
  return left ? text + blanks : blanks + text;
}

}  // namespace

std::string readableNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

json tableRows(vtkTable* table) {
  json rows = json::array();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row) {
    json object = json::object();
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
      object[table->GetColumnName(column)] = valueOf(table->GetValue(row, column));
    rows.push_back(object);
  }
  return rows;
}

std::string csvText(const json& rows) {
  std::string text;
  const auto appendLine = [&](const json& row, bool names) {
    std::string line;
    for (const auto& item : row.items())
      line += (line.empty() ? "" : ",") + (names ? item.key() : csvCell(item.value()));
    text += line + "\n";
  };
  if (!rows.empty()) appendLine(rows.front(), true);
  for (const json& row : rows) appendLine(row, false);
  return text;
}

std::string readableText(const json& rows) {
  if (rows.empty()) return {};
  const Lines lines = readableCells(rows);
  std::vector<size_t> widths(lines[0].size());
  for (const auto& line : lines)
    for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (size_t i = 0; i < line.size(); ++i) row += (i ? "  " : "") + padded(line[i], widths[i], i == 0);
    text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace mien
