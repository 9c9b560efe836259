#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "LineCutter.h"

namespace mien {

/// Reads a table with a header row by row. Cells stand between commas, or between semicolons or tabs when the header
/// has more of these; quotation marks and blanks around a cell are left out. Lines before the header that begin with #
/// are comments, later ones and empty lines are skipped. The text must live as long as the reader.
class CommaReader {
 public:
  static constexpr std::size_t mostColumns = 4096;
  static constexpr std::size_t longestLine = std::size_t{256} << 10;  ///< bytes

  explicit CommaReader(std::string_view text) : lines_(text) {}

  /// Reads the comments and the header. @return nothing, or what is wrong with line()
  std::string readHeader();

  /// Reads the next row; false at the end and at a fault.
  bool readRow();

  const std::vector<std::string_view>& comments() const { return comments_; }  ///< without # and blanks around
  int commentLine(std::size_t comment) const { return commentLines_[comment]; }
  const std::vector<std::string_view>& header() const { return header_; }
  const std::vector<std::string_view>& cells() const { return cells_; }
  const std::string& fault() const { return fault_; }  ///< why readRow() stopped before the end; else empty
  int line() const { return lines_.number(); }

  /// "column 5 (AU12)", for messages; column from 0.
  std::string columnName(std::size_t column) const;

 private:
  bool nextLine(std::string_view& line);
  void split(std::string_view line, std::vector<std::string_view>& cells);

  LineCutter lines_;
  std::vector<std::string_view> comments_, header_, cells_;
  std::vector<int> commentLines_;
  std::string fault_;
  char separator_ = ',';
};

/// The cell without the blanks and quotation marks around it.
std::string_view bareCell(std::string_view cell);

}  // namespace mien
