#include "FAPColumn.h"

#include <algorithm>
#include <string>

#include "FAPFields.h"
#include "FAPTable.h"
#include "SmallLetters.h"

namespace mien {

namespace {

std::string plainColumn(std::string_view text) {
  std::string name = inSmallLetters(text);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

std::optional<FAPColumn> findField(const std::string& name) {
  std::optional<FAPColumn> found;
  FAPFrame frame;
  int field = 0;
  visitHighLevelFields(frame, [&](std::string_view known, double&) {
    const std::string small = plainColumn(known);
    if (name == small || name == small.substr(5)) found = FAPColumn{field < visemeFields ? 1 : 2, field};
    ++field;
  });
  return found;
}

/// The number after "fap", 0 for none.
int numberAfterFAP(const std::string& name) {
  if (name.compare(0, 3, "fap") != 0) return 0;
  std::size_t begin = name.find_first_not_of('_', 3);
  if (begin == name.npos) return 0;
  const std::size_t end = std::min(name.find_first_not_of("0123456789", begin), name.size());
  if (end == begin || end - begin > 2 || (end < name.size() && name[end] != '_')) return 0;
  return std::stoi(name.substr(begin, end - begin));
}

}  // namespace

void FAPColumn::setValue(FAPFrame& frame, double value) const {
  if (fap >= FAPFrame::firstLowLevel) return frame.setValue(fap, value);
  int index = 0;
  visitHighLevelFields(frame, [&](const char*, double& place) {
    if (index++ == field) place = value;
  });
}

std::optional<FAPColumn> findFAPColumn(std::string_view text) {
  const std::string name = plainColumn(text);
  if (const auto field = findField(name)) return field;
  const int number = numberAfterFAP(name);
  if (number >= FAPFrame::firstLowLevel && number <= FAPFrame::count) return FAPColumn{number};
  for (const FAPDefinition& fap : fapTable)
    if (fap.number >= FAPFrame::firstLowLevel && name == fap.name) return FAPColumn{fap.number};
  return std::nullopt;
}

}  // namespace mien
