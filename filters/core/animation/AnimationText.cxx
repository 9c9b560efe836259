#include "AnimationText.h"

#include <algorithm>

#include "CaptureColumns.h"
#include "CaptureParser.h"
#include "CommaReader.h"
#include "FAPColumn.h"
#include "FAPCsvParser.h"
#include "FAPParser.h"

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
  if (*format == AnimationFormat::FAP) return parseFAP(text, sequence);
  if (*format == AnimationFormat::FAPCsv) return parseFAPCsv(text, sequence);
  const bool units = *format == AnimationFormat::ActionUnits;
  return parseCapture(text, units ? CaptureKind::ActionUnits : CaptureKind::Blendshapes, map, sequence);
}

}  // namespace mien
