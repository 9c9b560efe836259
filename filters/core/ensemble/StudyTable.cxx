#include "StudyTable.h"

#include <algorithm>
#include <cmath>

#include "Checksum.h"
#include "NumberText.h"
#include "StudyText.h"

namespace mien {

namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + "\"";
}

/// Whether a cell is one that row() writes for a text: plain, or quoted to its end.
bool isTextCell(std::string_view cell) {
  if (cell.empty() || cell.front() != '"') return cell.find_first_of(",\"") == std::string_view::npos;
  if (cell.size() < 2 || cell.back() != '"') return false;
  cell = cell.substr(1, cell.size() - 2);
  for (std::size_t i = 0; i < cell.size(); ++i)
    if (cell[i] == '"' && (++i == cell.size() || cell[i] != '"')) return false;
  return true;
}

/// Takes a number or nothing, and the comma behind it, off a line.
bool takeNumber(std::string_view& line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return false;
  const std::string_view cell = line.substr(0, comma);
  line.remove_prefix(comma + 1);
  return cell.empty() || parseNumber(cell).has_value();
}

std::string headOf(const Study& study, std::int64_t cases, std::string_view contents) {
  const std::string identity = hashText(writeStudy(study) + "\n" + std::string(contents));
  std::string head = "# mien ensemble table, version " + std::to_string(StudyTable::version) + ", study " + identity +
                     ", " + std::to_string(cases) + " cases, lengths in mm, angles in degrees\n" +
                     "case,id,face,scheme,a,harmonics,expression,frame";
  for (const std::string& measure : study.measures) head += "," + measure;
  return head + ",reason\n";
}

/// Takes the cell that begins a line, and the comma behind it, off the line; the inverse of quoted().
std::string takeCell(std::string_view& line) {
  std::string cell;
  std::size_t i = 0;
  if (!line.empty() && line.front() == '"') {
    const auto isQuotationMark = [&](std::size_t place) { return place < line.size() && line[place] == '"'; };
    for (i = 1; i < line.size() && !(isQuotationMark(i) && !isQuotationMark(i + 1)); ++i) {
      cell += line[i];
      if (isQuotationMark(i)) ++i;
    }
    ++i;
  } else {
    i = std::min(line.find(','), line.size());
    cell = line.substr(0, i);
  }
  line.remove_prefix(std::min(i + 1, line.size()));
  return cell;
}

}  // namespace

StudyTable::StudyTable(const Study& study, const StudyCases& cases, std::string_view contents)
    : study_(study), cases_(cases), head_(headOf(study, cases.count(), contents)) {}

std::string StudyTable::prefixOf(const StudyCase& one) const {
  const StudyPose& pose = study_.poses[one.pose];
  const FaceSurfaceOptions& surface = one.state.surface;
  return std::to_string(one.number) + "," + one.id + "," + quoted(study_.faces[one.face]) + "," + surface.scheme + "," +
         numberText(surface.smoothing[0]) + "," + std::to_string(surface.modes) + "," + quoted(pose.expression) + "," +
         (pose.isFrame ? numberText(pose.frame) : "") + ",";
}

std::string StudyTable::row(const StudyCase& one, const CaseValues& measured) const {
  std::string line = prefixOf(one);
  for (const double value : measured.values) {
    if (std::isfinite(value)) appendNumber(line, value);
    line += ",";
  }
  std::string reason = measured.reason;
  for (char& c : reason)
    if (c == '\n' || c == '\r') c = ' ';
  return line + quoted(reason) + "\n";
}

std::optional<std::int64_t> StudyTable::caseOf(std::string_view line) const {
  const auto number = parseWholeNumber(line.substr(0, line.find(',')));
  if (!number || *number < 0 || *number >= cases_.count()) return std::nullopt;
  const std::string prefix = prefixOf(cases_.at(*number));
  if (line.substr(0, prefix.size()) != prefix) return std::nullopt;
  line.remove_prefix(prefix.size());
  for (std::size_t i = 0; i < study_.measures.size(); ++i)
    if (!takeNumber(line)) return std::nullopt;
  if (!isTextCell(line)) return std::nullopt;
  return number;
}

std::vector<std::string> StudyTable::cellsOf(std::string_view line) const {
  constexpr std::size_t besidesMeasures = 9;
  std::vector<std::string> cells(besidesMeasures + study_.measures.size());
  for (std::string& cell : cells) cell = takeCell(line);
  return cells;
}

}  // namespace mien
