#include "PointTable.h"

#include <algorithm>
#include <array>
#include <set>

#include "CommaText.h"
#include "LineReader.h"
#include "NumberText.h"

namespace mien {

namespace {

const std::array<const char*, 3> axisNames = {"x", "y", "z"};
constexpr const char* noHeader = "the header must name marker, x and y";

struct PointColumns {
  std::size_t count = 0;
  int marker = -1, region = -1;
  std::array<int, 3> axes{};

  std::string find(const std::vector<std::string>& header) {
    count = header.size();
    marker = columnNamed(header, "marker");
    region = columnNamed(header, "region");
    for (int i = 0; i < 3; ++i) axes[i] = columnNamed(header, axisNames[i]);
    return marker < 0 || axes[0] < 0 || axes[1] < 0 ? noHeader + separatorHint(header) : "";
  }
};

std::string parsePosition(const std::vector<std::string>& cells, const PointColumns& columns, NamedPoint& point) {
  point.seen = true;
  for (int i = 0; i < 3; ++i) {
    if (columns.axes[i] < 0) continue;
    const std::string& cell = cells[columns.axes[i]];
    const std::optional<double> value = parseNumber(cell);
    if (!value && !cell.empty())
      return point.name + ": " + inQuotes(cell) + " in column " + axisNames[i] + " is no finite number";
    point.seen = point.seen && value;
    point.position[i] = value.value_or(0.0);
  }
  return {};
}

std::string parsePoint(const std::vector<std::string>& cells, const PointColumns& columns, NamedPoint& point) {
  if (cells.size() != columns.count)
    return "there are " + std::to_string(cells.size()) + " cells under " + std::to_string(columns.count) +
           " columns; give one for each, blank where a marker was not seen";
  point.name = cells[columns.marker];
  if (point.name.empty()) return "the marker has no name; give one";
  const std::string region = columns.region < 0 ? "" : cells[columns.region];
  const std::optional<int> number = parseRegion(region);
  if (!number)
    return point.name + ": " + inQuotes(region) + " is no region; regions run from 1 to 16, blank for by place";
  point.region = *number;
  return parsePosition(cells, columns, point);
}

constexpr int fewestSided = 4;  // landmarks: fewer may all be of a nose that is seen from the side

/// 1 for landmarks of the subject's left half of the face, -1 for those of the right, 0 near the midline and for none.
int sideOfLandmark(int landmark) {
  const auto within = [&](int first, int last) { return landmark >= first && landmark <= last; };
  if (within(0, 6) || within(17, 20) || within(36, 41) || within(48, 49) || within(59, 60)) return -1;
  return within(10, 16) || within(23, 26) || within(42, 47) || within(53, 55) || landmark == 64;
}

}  // namespace

std::optional<int> parseRegion(const std::string& cell) {
  if (cell.empty()) return 0;
  const std::optional<std::int64_t> number = parseWholeNumber(cell);
  return number && *number >= 1 && *number <= 16 ? std::optional<int>(static_cast<int>(*number)) : std::nullopt;
}

std::string PointTable::parse(const std::string& text, const MarkerOptions& options) {
  LineReader lines(text);
  PointColumns columns;
  PointTable parsed;
  std::set<std::string> names;
  std::string fault = lines.next() ? columns.find(splitAtCommas(lines.line())) : noHeader;
  if (!fault.empty()) return std::to_string(std::max(lines.number(), 1)) + ": " + fault;
  while (lines.next()) {
    NamedPoint point;
    point.line = lines.number();
    fault = parsePoint(splitAtCommas(lines.line()), columns, point);
    if (fault.empty() && !names.insert(point.name).second) fault = point.name + " is given twice; remove one of them";
    if (!fault.empty()) return std::to_string(point.line) + ": " + fault;
    point.position = options.upright(point.position);
    parsed.points.push_back(point);
  }
  if (parsed.points.empty()) return "1: there is no marker below the header";
  parsed.hasDepth = columns.axes[2] >= 0;
  parsed.hasRegions = columns.region >= 0;
  *this = parsed;
  return {};
}

std::string PointTable::write(const MarkerOptions& options) const {
  std::string text = std::string("marker,x,y") + (hasDepth ? ",z" : "") + (hasRegions ? ",region\n" : "\n");
  for (const NamedPoint& point : points) {
    const Eigen::Vector3d position = options.upright(point.position);
    text += point.name;
    for (int i = 0; i < (hasDepth ? 3 : 2); ++i) {
      text += ",";
      if (point.seen) appendNumber(text, position[i] == 0.0 ? 0.0 : position[i]);
    }
    if (hasRegions) text += "," + (point.region ? std::to_string(point.region) : std::string());
    text += "\n";
  }
  return text;
}

const NamedPoint* PointTable::find(const std::string& name) const {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const NamedPoint& point) { return point.name == name; });
  return found == points.end() ? nullptr : &*found;
}

std::string PointTable::findPupils(const MarkerOptions& options, EyePupils& pupils) const {
  if (options.neutralPupils) {
    pupils = {options.upright(options.neutralPupils->left), options.upright(options.neutralPupils->right)};
    return {};
  }
  for (const auto& [name, place] :
       {std::pair(&options.leftPupil, &pupils.left), std::pair(&options.rightPupil, &pupils.right)}) {
    const NamedPoint* pupil = find(*name);
    if (!pupil || !pupil->seen)
      return std::to_string(pupil ? pupil->line : 1) + ": the pupil " + *name +
             " is missing; give both pupils as markers, or their names or places with --pupils";
    *place = pupil->position;
  }
  return {};
}

std::string describePosture(const MarkerPlaces& places, bool wholeFace) {
  const std::string standing =
      "the chin lies above the eyes; say that y runs downwards (--y-down), that the pictures are mirrored "
      "(--mirrored), or exchange the pupils";
  const std::string sided =
      "the landmarks of the subject's right side lie beside the left pupil; exchange the pupils (pupil_left is the "
      "subject's own left), or correct --mirrored and --y-down";
  double height = 0.0, apart = 0.0;
  int landmarks = 0;
  bool chin = false;
  for (const auto& [name, place] : places) {
    const int landmark = landmarkNumber(name), side = sideOfLandmark(landmark);
    if ((landmark == 8 || name == "chin") && place.y() > 0.0) return standing;
    chin = chin || landmark == 8 || name == "chin";
    height += place.y();
    apart += side * place.x();
    landmarks += side != 0;
  }
  if (wholeFace && !chin && height > 0.0 && places.size() >= 16) return standing;
  return landmarks >= fewestSided && apart < 0.0 ? sided : "";
}

}  // namespace mien
