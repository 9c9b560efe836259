#include "FacialActionMap.h"

#include <algorithm>
#include <cmath>

#include "AnimationJson.h"
#include "FAPTable.h"
#include "MotionBasis.h"
#include "SmallLetters.h"

namespace mien {

namespace {

CaptureAction parseAction(const Json& json) {
  CaptureAction action;
  action.name = json.at("name").get<std::string>();
  within(action.name, [&] {
    refuseUnknownKeys(json, {"name", "description", "sided", "written_only", "stands_in", "weak", "faps"});
    action.description = json.value("description", std::string());
    action.sided = json.value("sided", false);
    action.writtenOnly = json.value("written_only", false);
    action.standsIn = json.value("stands_in", false);
    action.weak = json.value("weak", std::vector<int>());
    for (const auto& [key, value] : json.at("faps").items()) {
      if (!value.is_number() || !(std::abs(value.get<double>()) <= MotionBasis::largestValue))
        refuse("the value of FAP " + key + " must be a number within +-1e6");
      action.faps.emplace_back(parseFAPKey(key), value.get<double>());
    }
  });
  std::sort(action.faps.begin(), action.faps.end());
  return action;
}

std::vector<CaptureAction> parseActions(const Json& root, const char* group) {
  std::vector<CaptureAction> actions;
  for (const Json& json : root.at(group)) {
    actions.push_back(parseAction(json));
    const auto isSame = [&](const CaptureAction& other) { return other.name == actions.back().name; };
    if (std::find_if(actions.begin(), actions.end() - 1, isSame) != actions.end() - 1)
      refuse(actions.back().name + " is given twice");
  }
  return actions;
}

std::string plainAction(std::string_view name) {
  const bool shortSide = name.size() > 2 && (name[name.size() - 2] == '_' || name[name.size() - 2] == '-');
  const char side = shortSide ? inSmallLetters(name.substr(name.size() - 1))[0] : ' ';
  std::string text(side == 'l' || side == 'r' ? name.substr(0, name.size() - 2) : name);
  if (side == 'l') text += "left";
  if (side == 'r') text += "right";
  const auto isMark = [](char c) { return c == '_' || c == '-' || c == ' '; };
  text.erase(std::remove_if(text.begin(), text.end(), isMark), text.end());
  return inSmallLetters(text);
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
  const std::string fault = parseJson(json, "facial action map", faultLine, [&](const Json& root) {
    if (!root.is_object() || root.value("format", Json()) != "mien facial action map")
      refuse("\"format\" is not \"mien facial action map\"");
    if (!isKnownVersion(root.value("version", Json()), version)) refuse("the version is not 1, the only one known");
    refuseUnknownKeys(root, {"format", "version", "action_units", "blendshapes", "rotations", "left_out"});
    parsed.actionUnits = parseActions(root, "action_units");
    parsed.blendshapes = parseActions(root, "blendshapes");
    parsed.rotations = parseActions(root, "rotations");
  });
  if (fault.empty()) *this = std::move(parsed);
  return fault;
}

const CaptureAction* findAction(const std::vector<CaptureAction>& actions, std::string_view name) {
  const std::string wanted = plainAction(name);
  const auto found = std::find_if(actions.begin(), actions.end(),
                                  [&](const CaptureAction& action) { return plainAction(action.name) == wanted; });
  return found == actions.end() ? nullptr : &*found;
}

}  // namespace mien
