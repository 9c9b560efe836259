#include "ExpressionLibrary.h"

#include <algorithm>
#include <cmath>

#include "AnimationJson.h"
#include "MotionBasis.h"

namespace mien {

namespace {

std::pair<int, double> parseValue(const std::string& key, const Json& json) {
  const int fap = parseFAPKey(key);
  if (!json.is_number() || !(std::abs(json.get<double>()) <= MotionBasis::largestValue))
    refuse("the value of FAP " + key + " must be a number within +-1e6");
  return {fap, json.get<double>()};
}

FacialAction parseAction(const std::string& name, const Json& faps) {
  if (!faps.is_object()) refuse("\"faps\" must be an object of FAP numbers and values");
  FacialAction action{name, {}};
  for (const auto& [key, value] : faps.items()) action.values.push_back(parseValue(key, value));
  return action;
}

std::vector<FacialAction> parseActions(const Json& json) {
  if (json.contains("actions") == json.contains("faps")) refuse("either \"actions\" or \"faps\" is needed");
  if (json.contains("faps")) return {parseAction("", json["faps"])};
  std::vector<FacialAction> actions;
  for (const Json& action : json["actions"]) {
    refuseUnknownKeys(action, {"name", "faps"});
    actions.push_back(parseAction(action.at("name").get<std::string>(), action.at("faps")));
  }
  return actions;
}

void collectValues(ExpressionProfile& profile) {
  for (const FacialAction& action : profile.actions)
    for (const auto& value : action.values) {
      const bool twice = std::any_of(profile.values.begin(), profile.values.end(),
                                     [&](const auto& known) { return known.first == value.first; });
      if (twice) refuse("FAP " + std::to_string(value.first) + " stands in two places");
      profile.values.push_back(value);
    }
}

ExpressionProfile parseExpression(const Json& json) {
  ExpressionProfile profile;
  profile.name = json.at("name").get<std::string>();
  within(profile.name, [&] {
    refuseUnknownKeys(json, {"name", "select", "definition", "actions", "faps"});
    profile.select = json.at("select").get<int>();
    profile.definition = json.at("definition").get<std::string>();
    profile.actions = parseActions(json);
    collectValues(profile);
  });
  return profile;
}

std::vector<ExpressionProfile> parseExpressions(const Json& root) {
  const Json format = root.is_object() ? root.value("format", Json()) : Json();
  if (format != "mien expressions" && format != "mien visemes")
    refuse("\"format\" is not \"mien expressions\" or \"mien visemes\"");
  if (!isKnownVersion(root.value("version", Json()), ExpressionLibrary::version))
    refuse("the version is none of those known, 1 to " + std::to_string(ExpressionLibrary::version));
  refuseUnknownKeys(root, {"format", "version", "expressions"});
  std::vector<ExpressionProfile> expressions;
  for (const Json& expression : root.at("expressions")) expressions.push_back(parseExpression(expression));
  return expressions;
}

}  // namespace

std::string ExpressionLibrary::parse(const std::string& json) {
  std::vector<ExpressionProfile> expressions;
  const std::string fault =
      parseJson(json, "expressions", faultLine_, [&](const Json& root) { expressions = parseExpressions(root); });
  if (fault.empty()) expressions_ = std::move(expressions);
  return fault;
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
