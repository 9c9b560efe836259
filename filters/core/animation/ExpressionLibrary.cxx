#include "ExpressionLibrary.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace mien {

namespace {

using Json = nlohmann::json;

std::pair<int, double> parseValue(const std::string& key, const Json& json) {
  const bool digits = !key.empty() && key.size() <= 2 && key.find_first_not_of("0123456789") == std::string::npos;
  const int fap = digits ? std::stoi(key) : 0;
  if (fap < FAPFrame::firstLowLevel || fap > FAPFrame::count)
    throw std::invalid_argument("\"" + key + "\" is no FAP; use 3 to 68");
  if (!json.is_number() || !std::isfinite(json.get<double>()))
    throw std::invalid_argument("the value of FAP " + key + " must be a number");
  return {fap, json.get<double>()};
}

FacialAction parseAction(const std::string& name, const Json& faps) {
  if (!faps.is_object()) throw std::invalid_argument("\"faps\" must be an object of FAP numbers and values");
  FacialAction action{name, {}};
  for (const auto& [key, value] : faps.items()) action.values.push_back(parseValue(key, value));
  return action;
}

std::vector<FacialAction> parseActions(const Json& json) {
  if (json.contains("actions") == json.contains("faps"))
    throw std::invalid_argument("either \"actions\" or \"faps\" is needed");
  if (json.contains("faps")) return {parseAction("", json["faps"])};
  std::vector<FacialAction> actions;
  for (const Json& action : json["actions"])
    actions.push_back(parseAction(action.at("name").get<std::string>(), action.at("faps")));
  return actions;
}

void collectValues(ExpressionProfile& profile) {
  for (const FacialAction& action : profile.actions)
    for (const auto& value : action.values) {
      const bool twice = std::any_of(profile.values.begin(), profile.values.end(),
                                     [&](const auto& known) { return known.first == value.first; });
      if (twice) throw std::invalid_argument("FAP " + std::to_string(value.first) + " stands in two places");
      profile.values.push_back(value);
    }
}

ExpressionProfile parseExpression(const Json& json) {
  ExpressionProfile profile;
  profile.name = json.at("name").get<std::string>();
  try {
    profile.select = json.at("select").get<int>();
    profile.definition = json.at("definition").get<std::string>();
    profile.actions = parseActions(json);
    collectValues(profile);
  } catch (const std::exception& error) {
    throw std::invalid_argument(profile.name + ": " + error.what());
  }
  return profile;
}

bool isKnownVersion(const Json& version) {
  return version.is_number_integer() && version >= 1 && version <= ExpressionLibrary::version;
}

}  // namespace

std::string ExpressionLibrary::parse(const std::string& json) {
  std::vector<ExpressionProfile> expressions;
  try {
    const Json root = Json::parse(json);
    const Json format = root.is_object() ? root.value("format", Json()) : Json();
    if (format != "mien expressions" && format != "mien visemes")
      return "expressions: \"format\" is not \"mien expressions\" or \"mien visemes\"";
    if (!isKnownVersion(root.value("version", Json())))
      return "expressions: the version is none of those known, 1 to " + std::to_string(version);
    for (const Json& expression : root.at("expressions")) expressions.push_back(parseExpression(expression));
  } catch (const std::exception& error) {
    return std::string("expressions: ") + error.what();
  }
  expressions_ = std::move(expressions);
  return {};
}

const ExpressionProfile* ExpressionLibrary::find(const std::string& name) const {
  const auto found =
      std::find_if(expressions_.begin(), expressions_.end(), [&](const auto& e) { return e.name == name; });
  return found == expressions_.end() ? nullptr : &*found;
}

const ExpressionProfile* ExpressionLibrary::find(int select) const {
  const auto found =
      std::find_if(expressions_.begin(), expressions_.end(), [&](const auto& e) { return e.select == select; });
  return found == expressions_.end() ? nullptr : &*found;
}

bool ExpressionLibrary::add(const std::string& name, double intensity, FAPFrame& frame) const {
  const ExpressionProfile* profile = find(name);
  if (!profile) return false;
  const double share = std::isfinite(intensity) ? std::clamp(intensity, 0.0, 1.0) : 0.0;
  for (const auto& [fap, value] : profile->values) frame.setValue(fap, frame.value(fap) + share * value);
  return true;
}

}  // namespace mien
