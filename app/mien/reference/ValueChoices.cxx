#include "ValueChoices.h"

#include <algorithm>
#include <regex>

#include "AnimationData.h"
#include "ExpressionLibrary.h"
#include "FigureCatalogue.h"
#include "NamedTables.h"

namespace mien {

namespace {

using Words = std::vector<std::string>;

Words namesIn(const ExpressionLibrary& library) {
  Words names;
  for (const ExpressionProfile& entry : library.expressions()) names.push_back(entry.name);
  return names;
}

Words expressions(const OptionDescription&) {
  return namesIn(defaultExpressions());
}

/// As a command line takes them: "p_b_m".
Words visemes(const OptionDescription&) {
  Words names = namesIn(defaultVisemes());
  for (std::string& name : names) std::replace(name.begin(), name.end(), ' ', '_');
  return names;
}

Words tables(const OptionDescription&) {
  return tableNames();
}

Words figures(const OptionDescription&) {
  Words names;
  for (const CatalogueFigure& figure : figureCatalogue()) names.push_back(figure.id);
  return names;
}

Words views(const OptionDescription&) {
  return {"front", "side", "left", "right", "back", "top", "45", "45-right"};
}

Words files(const OptionDescription&) {
  return {};
}

/// The first list of words in a sentence, at its beginning or after a colon: "Of the figure: light, dark, print".
Words listedInHelp(const OptionDescription& option) {
  static const std::regex list("(?:^|: )([A-Za-z0-9-]+(?:(?:, or |, | or )[A-Za-z0-9-]+)+)(?=$|[;,]| [[(])");
  static const std::regex between(", or |, | or ");
  std::smatch found;
  if (!std::regex_search(option.help, found, list)) return {};
  const std::string words = found[1];
  return {std::sregex_token_iterator(words.begin(), words.end(), between, -1), {}};
}

Words schemes(const OptionDescription& option) {
  Words names = listedInHelp(option);
  if (option.help.find("or all") != std::string::npos) names.push_back("all");
  return names;
}

/// Where the words of a value come from; the first line that fits counts. `command` is the beginning of its path.
struct Source {
  const char* command;
  const char* option;
  Words (*words)(const OptionDescription&);
};

const Source sources[] = {
    {"mien fdt fit", "--expression", files},
    {"mien", "--expression", expressions},
    {"mien fdt from-fap", "expressions", expressions},
    {"mien", "--viseme", visemes},
    {"mien", "--fdt", tables},
    {"mien fdt", "--against", tables},
    {"mien fdt", "table", tables},
    {"mien fdt", "tables", tables},
    {"mien fdt", "inputs", tables},
    {"mien figure", "figure", figures},
    {"mien", "--view", views},
    {"mien", "--against", listedInHelp},
    {"mien", "--bits", listedInHelp},
    {"mien", "--colormap", listedInHelp},
    {"mien", "--format", listedInHelp},
    {"mien", "--precision", listedInHelp},
    {"mien", "--scheme", schemes},
    {"mien", "--style", listedInHelp},
    {"mien", "--theme", listedInHelp},
    {"mien", "--units", listedInHelp},
};

/// "{c1,c2}" of a declaration.
Words declaredWords(const std::string& limits) {
  static const std::regex word("[^{},]+");
  if (limits.empty() || limits.front() != '{') return {};
  return {std::sregex_token_iterator(limits.begin(), limits.end(), word), {}};
}

}  // namespace

std::vector<std::string> valueChoices(const CommandDescription& command, const OptionDescription& option) {
  if (option.value.empty()) return {};
  const Words declared = declaredWords(option.limits);
  if (!declared.empty()) return declared;
  for (const Source& source : sources)
    if (command.path.rfind(source.command, 0) == 0 && option.longestName() == source.option)
      return source.words(option);
  return {};
}

}  // namespace mien
