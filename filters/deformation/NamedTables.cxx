#include "NamedTables.h"

#include <algorithm>
#include <utility>

#include "AngerTable.h"
#include "DisgustTable.h"
#include "FearTable.h"
#include "JoyTable.h"
#include "PackedTable.h"
#include "SadnessTable.h"
#include "SmileTable.h"
#include "SurpriseTable.h"
#include "TableText.h"
#include "TextFileReader.h"

namespace mien {

namespace {

// A table with deviations has about 9 kB; a file hundreds of times larger is something else.
constexpr std::size_t largestText = 5'000'000;

const std::vector<std::pair<std::string, DeformationTable>>& tables() {
  static const auto parsed = [] {
    std::vector<std::pair<std::string, DeformationTable>> result;
    for (const auto& [name, text] :
         {std::pair("anger", AngerTable()), std::pair("disgust", DisgustTable()), std::pair("fear", FearTable()),
          std::pair("joy", JoyTable()), std::pair("sadness", SadnessTable()), std::pair("surprise", SurpriseTable()),
          std::pair("smile", SmileTable())}) {
      result.emplace_back(name, DeformationTable());
      parseTable(text, result.back().second);
    }
    return result;
  }();
  return parsed;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

const std::vector<std::string>& tableNames() {
  static const auto names = [] {
    std::vector<std::string> result;
    for (const auto& table : tables()) result.push_back(table.first);
    return result;
  }();
  return names;
}

const DeformationTable* namedTable(const std::string& name) {
  const auto found =
      std::find_if(tables().begin(), tables().end(), [&](const auto& table) { return table.first == name; });
  return found == tables().end() ? nullptr : &found->second;
}

std::string readNamedTable(const std::string& nameOrFile, DeformationTable& table) {
  if (const DeformationTable* known = namedTable(nameOrFile)) {
    table = *known;
    return {};
  }
  std::string text;
  std::string fault = readTextFile(nameOrFile, largestText, text);
  const bool unreadable = !fault.empty();
  if (!unreadable && isPackedTable(text)) {
    fault = unpackTable(text, table);
    return fault.empty() ? "" : nameOrFile + ": " + fault;
  }
  if (!unreadable) fault = parseTable(text, table);
  if (unreadable && nameOrFile.find_first_of("./\\") == std::string::npos)
    fault += "; there are the tables " + listed(tableNames());
  return fault.empty() ? "" : nameOrFile + ":" + fault;
}

}  // namespace mien
