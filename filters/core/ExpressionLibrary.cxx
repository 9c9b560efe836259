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

ExpressionProfile parseExpression(const Json& json) {
  ExpressionProfile profile;
  profile.name = json.at("name").get<std::string>();
  try {
    profile.select = json.at("select").get<int>();
    profile.definition = json.at("definition").get<std::string>();
    for (const auto& [key, value] : json.at("faps").items()) profile.values.push_back(parseValue(key, value));
  } catch (const std::exception& error) {
    throw std::invalid_argument(profile.name + ": " + error.what());
  }
  return profile;
}

}  // namespace

std::string ExpressionLibrary::parse(const std::string& json) {
  std::vector<ExpressionProfile> expressions;
  try {
    const Json root = Json::parse(json);
    const Json format = root.is_object() ? root.value("format", Json()) : Json();
    if (format != "mien expressions" && format != "mien visemes")
      return "expressions: \"format\" is not \"mien expressions\" or \"mien visemes\"";
    if (root.value("version", Json()) != version) return "expressions: the version is not 1, the only one known";
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
