#include "AnimationText.h"

#include <algorithm>

#include "CaptureColumns.h"
#include "CaptureParser.h"
#include "CommaReader.h"
#include "Counted.h"
#include "FAPColumn.h"
#include "FAPCsvParser.h"
#include "FAPParser.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr std::size_t headOfFile = std::size_t{1} << 20;  // bytes in which comments and header must lie

/// Whether a header is that of a table: a .fap file begins with its version or with a mask, a table with a name.
bool isTable(const std::vector<std::string_view>& header) {
  const std::string_view first = header.front();
  const bool isNumber = !first.empty() && first[0] >= '0' && first[0] <= '9';
  return !isNumber && (header.size() > 1 || findFAPColumn(first));
}

std::size_t countFAPs(const std::vector<std::string_view>& header) {
  return static_cast<std::size_t>(std::count_if(header.begin(), header.end(),
                                                [](std::string_view name) { return findFAPColumn(name).has_value(); }));
}

/// What a text that begins neither as a .fap file nor with names of columns lacks; nothing for any other.
std::string describeNoHeader(std::string_view text) {
  CommaReader reader(text.substr(0, headOfFile));
  if (!reader.readHeader().empty()) {
    const bool empty = text.find_first_not_of(" \t\r\n") == text.npos;
    return empty ? "the file is empty; a .fap file begins with version, name, rate and frames, a table (.csv) with the "
                   "names of its columns"
                 : "";
  }
  const auto isNumber = [](std::string_view cell) { return cell.empty() || parseNumber(cell).has_value(); };
  const std::vector<std::string_view>& cells = reader.header();
  const bool commas = text.substr(0, headOfFile).find_first_of(",;") != text.npos;
  if (cells.size() < 2 || !commas || !std::all_of(cells.begin(), cells.end(), isNumber)) return {};
  return "the table has no header; its first line must name the columns, such as frame,time,FAP51,FAP52";
}

/// Columns of other kinds than the one that is read.
std::string describeMixture(std::string_view text, AnimationFormat format, const FacialActionMap& map) {
  CommaReader reader(text.substr(0, headOfFile));
  if (!reader.readHeader().empty()) return {};
  const std::pair<AnimationFormat, std::size_t> kinds[] = {
      {AnimationFormat::FAPCsv, countFAPs(reader.header())},
      {AnimationFormat::ActionUnits, CaptureColumns::ofActionUnits(reader.header(), map).actions},
      {AnimationFormat::Blendshapes, CaptureColumns::ofBlendshapes(reader.header(), map).actions}};
  std::string others;
  for (const auto& [kind, columns] : kinds)
    if (kind != format && columns > 0)
      others += (others.empty() ? "" : " and ") + counted(columns, "column") + " of " + std::string(nameOf(kind));
  if (others.empty()) return {};
  return "the file mixes kinds: it is read as " + std::string(nameOf(format)) + ", without " + others +
         "; give each kind a file of its own";
}

constexpr const char* unknownTable =
    "no column is known; name them FAP3 .. FAP68, AU1 .. AU64 or as ARKit's blendshapes, or say with mien convert "
    "--from what it is";

}  // namespace

std::string_view nameOf(AnimationFormat format) {
  switch (format) {
    case AnimationFormat::FAP:
      return "FAPs (.fap)";
    case AnimationFormat::FAPCsv:
      return "FAPs (table)";
    case AnimationFormat::ActionUnits:
      return "FACS action units";
    case AnimationFormat::Blendshapes:
      return "ARKit blendshapes";
  }
  return "";
}

std::optional<AnimationFormat> recogniseAnimation(std::string_view text, const FacialActionMap& map) {
  CommaReader reader(text.substr(0, headOfFile));
  const bool hasHeader = reader.readHeader().empty();
  for (const std::string_view comment : reader.comments())
    if (comment.substr(0, 12) == "mien fap csv") return AnimationFormat::FAPCsv;
  if (!hasHeader || !isTable(reader.header())) return AnimationFormat::FAP;
  const std::size_t faps = countFAPs(reader.header());
  const std::size_t units = CaptureColumns::ofActionUnits(reader.header(), map).actions;
  const std::size_t shapes = CaptureColumns::ofBlendshapes(reader.header(), map).actions;
  const std::size_t most = std::max({faps, units, shapes});
  if (most == 0) return std::nullopt;
  if (most == faps) return AnimationFormat::FAPCsv;
  return most == units ? AnimationFormat::ActionUnits : AnimationFormat::Blendshapes;
}

std::optional<FAPParseError> parseAnimation(std::string_view text, std::optional<AnimationFormat> format,
                                            const FacialActionMap& map, FAPSequence& sequence) {
  if (text.size() > largestFAPText) return parseFAP(text, sequence);  // which refuses it
  if (!format) format = recogniseAnimation(text, map);
  if (!format) return FAPParseError{1, unknownTable};
  if (*format == AnimationFormat::FAP) {
    const std::string fault = describeNoHeader(text);
    return fault.empty() ? parseFAP(text, sequence) : FAPParseError{1, fault};
  }
  const bool units = *format == AnimationFormat::ActionUnits;
  const auto error =
      *format == AnimationFormat::FAPCsv
          ? parseFAPCsv(text, sequence)
          : parseCapture(text, units ? CaptureKind::ActionUnits : CaptureKind::Blendshapes, map, sequence);
  if (error) return error;
  const std::string mixture = describeMixture(text, *format, map);
  if (!mixture.empty()) sequence.warnings.insert(sequence.warnings.begin(), FAPWarning{1, mixture});
  return std::nullopt;
}

}  // namespace mien
