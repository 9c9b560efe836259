#include "MovementText.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>
#include <vector>

#include "AnimationData.h"
#include "Arguments.h"
#include "ExpressionLibrary.h"
#include "FAPColumn.h"
#include "Failure.h"

namespace mien {

namespace {

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\n\r";
  const size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

struct Share {
  std::string name;
  std::optional<double> value;
};

/// "joy:0.6" for each item of a list.
std::vector<Share> parseShares(const std::string& option, const std::string& text) {
  std::vector<Share> shares;
  for (const std::string& item : splitText(text, ',')) {
    const size_t colon = item.find(':');
    Share share{trimmed(item.substr(0, colon)), std::nullopt};
    if (share.name.empty()) throw ValueFailure(option + " '" + text + "' has a part without a name");
    if (colon != std::string::npos) share.value = parseNumber(option, trimmed(item.substr(colon + 1)));
    shares.push_back(std::move(share));
  }
  return shares;
}

bool isDigit(unsigned char c) {
  return std::isdigit(c) != 0;
}

/// For comparing names of visemes: _ is a blank, capitals do not count.
std::string comparable(std::string name) {
  for (char& c : name) c = c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

std::string visemeName(const std::string& option, const std::string& name) {
  const ExpressionLibrary& visemes = defaultVisemes();
  if (std::all_of(name.begin(), name.end(), isDigit)) {
    const ExpressionProfile* viseme = visemes.find(parseWholeNumber(option, name));
    if (viseme) return viseme->name;
  }
  std::string all;
  for (const ExpressionProfile& viseme : visemes.expressions()) {
    if (comparable(viseme.name) == comparable(name)) return viseme.name;
    std::string written = viseme.name;
    std::replace(written.begin(), written.end(), ' ', '_');
    all += (all.empty() ? "" : ", ") + std::to_string(viseme.select) + " " + written;
  }
  throw ValueFailure(option + ": there is no viseme '" + name + "'; there are " + all);
}

template <class Key>
void addOnce(const std::string& option, const std::string& name, const Key& key, double value,
             std::map<Key, double>& values) {
  if (!values.emplace(key, value).second) throw ValueFailure(option + " gives " + name + " twice");
}

int lowLevelFAP(const std::string& option, const std::string& name) {
  const bool isNumber = !name.empty() && name.find_first_not_of("+-0123456789") == std::string::npos;
  if (isNumber) return parseWholeNumber(option, name);
  const std::optional<FAPColumn> column = findFAPColumn(name);
  if (column && column->field < 0) return column->fap;
  throw ValueFailure(option + " '" + name + "' is no low-level FAP; write a number 3 .. 68 or a name such as open_jaw" +
                     (column ? " (visemes and expressions have --viseme and --expression)" : ""));
}

}  // namespace

std::map<std::string, double> parseExpressions(const std::string& option, const std::string& text) {
  std::map<std::string, double> expressions;
  for (const Share& share : parseShares(option, text))
    addOnce(option, share.name, share.name, share.value.value_or(1.0), expressions);
  return expressions;
}

std::map<std::string, double> parseVisemes(const std::string& option, const std::string& text) {
  const std::vector<Share> shares = parseShares(option, text);
  if (shares.size() > 2) throw ValueFailure(option + " '" + text + "' has more than the two visemes that blend");
  std::map<std::string, double> visemes;
  for (size_t i = 0; i < shares.size(); ++i) {
    const std::optional<double> other = shares.size() == 2 ? shares[1 - i].value : 0.0;
    const double rest = other ? std::max(0.0, 1.0 - *other) : 0.5;
    const std::string name = visemeName(option, shares[i].name);
    addOnce(option, name, name, shares[i].value.value_or(rest), visemes);
  }
  return visemes;
}

std::map<int, double> parseFAPValues(const std::string& option, const std::string& text) {
  std::map<int, double> values;
  for (const std::string& item : splitText(text, ',')) {
    const size_t equals = item.find('=');
    if (equals == std::string::npos)
      throw ValueFailure(option + " '" + item +
                         "' is no FAP value; write a FAP and its value as 53=200 or open_jaw=200");
    const int fap = lowLevelFAP(option, trimmed(item.substr(0, equals)));
    addOnce(option, "FAP " + std::to_string(fap), fap, parseNumber(option, trimmed(item.substr(equals + 1))), values);
  }
  return values;
}

}  // namespace mien
