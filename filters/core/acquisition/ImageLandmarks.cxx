#include "ImageLandmarks.h"

#include <algorithm>
#include <vector>

#include "CommaText.h"
#include "LineReader.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr std::size_t mostPoints = 10'000;

struct PlaceColumns {
  std::size_t count = 0;
  int landmark = -1, x = -1, y = -1;

  std::string find(const std::vector<std::string>& header) {
    count = header.size();
    landmark = columnNamed(header, "landmark");
    x = columnNamed(header, "x");
    y = columnNamed(header, "y");
    return std::min({landmark, x, y}) < 0 ? "the header must name the columns landmark, x and y" : "";
  }
};

std::string addRow(const std::vector<std::string>& cells, const PlaceColumns& columns, ImageLandmarks& landmarks) {
  if (cells.size() != columns.count)
    return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(columns.count) + " columns";
  const std::string& name = cells[columns.landmark];
  if (name.empty()) return "the landmark has no number and no name";
  const auto x = parseNumber(cells[columns.x]), y = parseNumber(cells[columns.y]);
  if (!x || !y) return inQuotes(x ? cells[columns.y] : cells[columns.x]) + " is no finite number; give pixels";
  if (landmarks.size() >= mostPoints) return "there are too many landmarks; give 68, or 25 points";
  if (!landmarks.emplace(name, Eigen::Vector2d(*x, *y)).second)
    return "landmark " + inQuotes(name) + " is given twice; remove one of them";
  return {};
}

}  // namespace

std::string parseImageLandmarks(const std::string& text, ImageLandmarks& landmarks) {
  LineReader lines(text);
  PlaceColumns columns;
  ImageLandmarks parsed;
  std::string fault =
      lines.next() ? columns.find(splitAtCommas(lines.line())) : "the file is empty; give a header and landmarks";
  while (fault.empty() && lines.next()) fault = addRow(splitAtCommas(lines.line()), columns, parsed);
  if (fault.empty() && parsed.empty()) fault = "there are no landmarks after this line";
  if (!fault.empty()) return std::to_string(std::max(1, lines.number())) + ": " + fault;
  landmarks = std::move(parsed);
  return {};
}

}  // namespace mien
