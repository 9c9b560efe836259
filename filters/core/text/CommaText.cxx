#include "CommaText.h"

#include <algorithm>

namespace mien {

namespace {

std::string trimmed(const std::string& text) {
  const char* const around = " \t\r\"";
  const auto first = text.find_first_not_of(around);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(around) - first + 1);
}

}  // namespace

std::vector<std::string> splitAtCommas(const std::string& line) {
  std::vector<std::string> cells;
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

std::string separatorHint(const std::vector<std::string>& header) {
  if (header.size() != 1) return {};
  const bool semicolons = header[0].find(';') != std::string::npos, tabs = header[0].find('\t') != std::string::npos;
  if (!semicolons && !tabs) return {};
  return std::string("; its cells are separated by ") + (semicolons ? "semicolons" : "tabs") +
         ": export it with commas between cells and points in numbers";
}

int columnNamed(const std::vector<std::string>& header, const std::string& name) {
  const auto found = std::find(header.begin(), header.end(), name);
  return found == header.end() ? -1 : static_cast<int>(found - header.begin());
}

}  // namespace mien
