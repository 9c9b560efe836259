#include "NamedTables.h"

#include <algorithm>
#include <utility>

#include "AngerTable.h"
#include "DisgustTable.h"
#include "FearTable.h"
#include "InlineText.h"
#include "JoyTable.h"
#include "PackedTable.h"
#include "SadnessTable.h"
#include "SmileTable.h"
#include "SurpriseTable.h"
#include "TableList.h"
#include "TableText.h"
#include "TextFileReader.h"

namespace mien {

namespace {

// A table with deviations has about 9 kB; a file hundreds of times larger is something else.
constexpr std::size_t largestTableText = 5'000'000;

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

/// The sum of the displacements of several tables.
std::string readTableList(const std::string& text, DeformationTable& table) {
  std::vector<WeightedName> names;
  std::string fault = parseTableList(text, names);
  std::vector<std::pair<DeformationTable, double>> tables(names.size());
  for (std::size_t i = 0; i < names.size() && fault.empty(); ++i) {
    tables[i].second = names[i].weight;
    fault = readNamedTable(names[i].name, tables[i].first);
  }
  if (fault.empty()) table = DeformationTable::weighted(tables);
  return fault;
}

bool hasPackedName(const std::string& file) {
  const std::string ending = ".fdt";
  return file.size() >= ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0;
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
  if (isInlineText(nameOrFile)) {
    const std::string fault = parseTable(nameOrFile, table);
    return fault.empty() ? "" : "table:" + fault;
  }
  std::string text;
  std::string fault = readTextFile(nameOrFile, largestTableText, text);
  const bool unreadable = !fault.empty();
  if (unreadable && nameOrFile.find(',') != std::string::npos) return readTableList(nameOrFile, table);
  if (!unreadable && isPackedTable(text)) {
    fault = unpackTable(text, table);
    return fault.empty() ? "" : nameOrFile + ": " + fault;
  }
  if (!unreadable && hasPackedName(nameOrFile))
    return nameOrFile + ": it is no packed table, which begins with other bytes; write one with mien fdt pack";
  if (!unreadable) fault = parseTable(text, table);
  if (unreadable && nameOrFile.find_first_of("./\\") == std::string::npos)
    fault += "; there are the tables " + listed(tableNames());
  return fault.empty() ? "" : nameOrFile + ":" + fault;
}

}  // namespace mien
