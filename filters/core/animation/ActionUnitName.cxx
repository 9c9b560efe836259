#include "ActionUnitName.h"

#include <algorithm>
#include <string>

#include "SmallLetters.h"

namespace mien {

namespace {

bool startsWithAU(std::string_view text) {
  return text.size() > 2 && (text[0] == 'A' || text[0] == 'a') && (text[1] == 'U' || text[1] == 'u');
}

/// What follows the number.
bool readEnding(std::string_view ending, bool sidesAreSmall, ActionUnitName& name) {
  using Side = ActionUnitName::Side;
  if (ending.empty()) return true;
  if (ending == "_c") name.kind = ActionUnitName::Kind::Presence;
  if (ending == "_r" && !sidesAreSmall) name.kind = ActionUnitName::Kind::Intensity;
  if (name.kind != ActionUnitName::Kind::Plain) return true;
  const std::string side = inSmallLetters(ending.substr(ending[0] == '_' || ending[0] == '-' ? 1 : 0));
  if (side == "l" || side == "left") name.side = Side::Left;
  if (side == "r" || side == "right") name.side = Side::Right;
  return name.side != Side::Both;
}

}  // namespace

std::optional<ActionUnitName> parseActionUnitName(std::string_view text, bool sidesAreSmall) {
  ActionUnitName name;
  if (text.size() > 2 && text[1] == '_' && startsWithAU(text.substr(2))) {
    if (text[0] != 'L' && text[0] != 'R') return std::nullopt;
    name.side = text[0] == 'L' ? ActionUnitName::Side::Left : ActionUnitName::Side::Right;
    text.remove_prefix(2);
  }
  if (!startsWithAU(text)) return std::nullopt;
  text.remove_prefix(2);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0 || digits > 2) return std::nullopt;
  name.unit = std::stoi(std::string(text.substr(0, digits)));
  const std::string_view ending = text.substr(digits);
  if (name.side != ActionUnitName::Side::Both && !ending.empty()) return std::nullopt;
  if (!readEnding(ending, sidesAreSmall, name)) return std::nullopt;
  return name;
}

}  // namespace mien
