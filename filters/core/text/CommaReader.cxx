#include "CommaReader.h"

#include <algorithm>

#include "NumberText.h"

namespace mien {

namespace {

constexpr std::size_t mostComments = 64;  // more are skipped unread

char commonestSeparator(std::string_view line) {
  const auto count = [line](char separator) { return std::count(line.begin(), line.end(), separator); };
  char commonest = ',';
  for (const char separator : {';', '\t'})
    if (count(separator) > count(commonest)) commonest = separator;
  return commonest;
}

}  // namespace

std::string_view bareCell(std::string_view cell) {
  const char* const around = " \t\v\f\"";
  const std::size_t first = cell.find_first_not_of(around);
  return first == cell.npos ? std::string_view() : cell.substr(first, cell.find_last_not_of(around) - first + 1);
}

bool CommaReader::nextLine(std::string_view& line) {
  while (fault_.empty() && lines_.next(line)) {
    if (line.find('\0') != line.npos)
      fault_ = "there is a NUL byte; a table is plain text";
    else if (line.size() > longestLine)
      fault_ = "the line has " + std::to_string(line.size()) + " bytes; at most " + std::to_string(longestLine) +
               " are read";
    else if (!bareCell(line).empty())
      return true;
  }
  return false;
}

std::string CommaReader::readHeader() {
  std::string_view line;
  while (nextLine(line)) {
    const std::string_view bare = bareCell(line);
    if (bare[0] != '#') {
      separator_ = commonestSeparator(line);
      split(line, header_);
      if (header_.size() > mostColumns)
        fault_ = "there are " + std::to_string(header_.size()) + " columns; at most " + std::to_string(mostColumns) +
                 " are read";
      return fault_;
    }
    if (comments_.size() == mostComments) continue;
    comments_.push_back(bareCell(bare.substr(1)));
    commentLines_.push_back(lines_.number());
  }
  return fault_.empty() ? "there is no header; the first line names the columns" : fault_;
}

bool CommaReader::readRow() {
  std::string_view line;
  do {
    if (!nextLine(line)) return false;
  } while (bareCell(line)[0] == '#');
  split(line, cells_);
  return true;
}

void CommaReader::split(std::string_view line, std::vector<std::string_view>& cells) {
  cells.clear();
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (quoted || line[i] != separator_) continue;
    cells.push_back(bareCell(line.substr(begin, i - begin)));
    begin = i + 1;
  }
  cells.push_back(bareCell(line.substr(begin)));
}

std::string CommaReader::columnName(std::size_t column) const {
  return "column " + std::to_string(column + 1) + " (" + inQuotes(header_[column]) + ")";
}

}  // namespace mien
