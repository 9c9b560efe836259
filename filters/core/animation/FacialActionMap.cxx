#include "FacialActionMap.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "FAPTable.h"

namespace mien {

namespace {

using Json = nlohmann::json;

constexpr double largestValue = 1e6;  // FAP units

int parseFAP(const std::string& key) {
  const bool digits = !key.empty() && key.size() <= 2 && key.find_first_not_of("0123456789") == std::string::npos;
  const int fap = digits ? std::stoi(key) : 0;
  if (fap < FAPFrame::firstLowLevel || fap > FAPFrame::count)
    throw std::invalid_argument("\"" + key + "\" is no FAP; use 3 to 68");
  return fap;
}

CaptureAction parseAction(const Json& json) {
  CaptureAction action;
  action.name = json.at("name").get<std::string>();
  try {
    action.description = json.value("description", std::string());
    action.sided = json.value("sided", false);
    action.writtenOnly = json.value("written_only", false);
    action.weak = json.value("weak", std::vector<int>());
    for (const auto& [key, value] : json.at("faps").items()) {
      if (!value.is_number() || !(std::abs(value.get<double>()) <= largestValue))
        throw std::invalid_argument("the value of FAP " + key + " must be a number within +-1e6");
      action.faps.emplace_back(parseFAP(key), value.get<double>());
    }
  } catch (const std::exception& error) {
    throw std::invalid_argument(action.name + ": " + error.what());
  }
  std::sort(action.faps.begin(), action.faps.end());
  return action;
}

std::vector<CaptureAction> parseActions(const Json& root, const char* group) {
  std::vector<CaptureAction> actions;
  for (const Json& json : root.at(group)) {
    actions.push_back(parseAction(json));
    const auto isSame = [&](const CaptureAction& other) { return other.name == actions.back().name; };
    if (std::find_if(actions.begin(), actions.end() - 1, isSame) != actions.end() - 1)
      throw std::invalid_argument(actions.back().name + " is given twice");
  }
  return actions;
}

std::string plain(std::string_view name) {
  const bool shortSide = name.size() > 2 && (name[name.size() - 2] == '_' || name[name.size() - 2] == '-');
  const char side = shortSide ? static_cast<char>(std::tolower(static_cast<unsigned char>(name.back()))) : ' ';
  std::string text(side == 'l' || side == 'r' ? name.substr(0, name.size() - 2) : name);
  if (side == 'l') text += "left";
  if (side == 'r') text += "right";
  const auto isMark = [](char c) { return c == '_' || c == '-' || c == ' '; };
  text.erase(std::remove_if(text.begin(), text.end(), isMark), text.end());
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

CaptureAction sideOf(const CaptureAction& action, bool left) {
  CaptureAction side = action;
  side.name += left ? "L" : "R";
  side.faps.clear();
  for (const auto& [fap, value] : action.faps) {
    const int partner = fapDefinition(fap).mirrorPartner;
    if (partner == fap)
      side.faps.emplace_back(fap, value / 2.0);
    else if (left == (fap < partner))  // the left one of a pair has the smaller number
      side.faps.emplace_back(fap, value);
  }
  return side;
}

std::string FacialActionMap::parse(const std::string& json) {
  FacialActionMap parsed;
  try {
    const Json root = Json::parse(json);
    if (!root.is_object() || root.value("format", Json()) != "mien facial action map")
      return "facial action map: \"format\" is not \"mien facial action map\"";
    if (root.value("version", Json()) != version) return "facial action map: the version is not 1, the only one known";
    parsed.actionUnits = parseActions(root, "action_units");
    parsed.blendshapes = parseActions(root, "blendshapes");
    parsed.rotations = parseActions(root, "rotations");
  } catch (const std::exception& error) {
    return std::string("facial action map: ") + error.what();
  }
  *this = std::move(parsed);
  return {};
}

const CaptureAction* findAction(const std::vector<CaptureAction>& actions, std::string_view name) {
  const std::string wanted = plain(name);
  const auto found = std::find_if(actions.begin(), actions.end(),
                                  [&](const CaptureAction& action) { return plain(action.name) == wanted; });
  return found == actions.end() ? nullptr : &*found;
}

}  // namespace mien
