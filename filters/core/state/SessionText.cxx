#include "SessionText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace mien {

namespace {

using json = nlohmann::json;
using ordered = nlohmann::ordered_json;

constexpr const char* format = "mien session";
constexpr const char* faceStateKey = "mien_face_state";
constexpr const char* advice = "; open an earlier copy";
constexpr int deepest = 32;  // levels; a session has seven, and copies of far deeper ones would exhaust the stack

std::string lineOf(const std::string& text, size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return std::to_string(1 + std::count(text.begin(), end, '\n'));
}

std::string versionFault(const json& document) {
  const auto found = document.find("version");
  if (found == document.end() || !found->is_number_integer() || *found < 1)
    return "the member 'version' is no whole number from 1 up";
  if (*found > sessionVersion)
    return "it is of a later version of Mien; this one reads sessions up to version " + std::to_string(sessionVersion);
  return {};
}

}  // namespace

std::string readSession(const std::string& text, json& session) {
  json document;
  const auto isShallow = [](int depth, json::parse_event_t, json&) { return depth < deepest; };
  try {
    document = json::parse(text, isShallow);
  } catch (const json::parse_error& error) {
    if (error.byte > text.size()) return "it ends at line " + lineOf(text, error.byte) + " (cut off?)" + advice;
    return "line " + lineOf(text, error.byte) + " is damaged: no JSON from there on" + advice;
  } catch (const json::exception&) {
    return "it holds a number that is too large";
  }
  if (!document.is_object()) return "it is no session: its JSON is no object";
  if (document.contains(faceStateKey)) {
    session = json::object();
    session["face"] = std::move(document);
    return {};
  }
  const auto found = document.find("format");
  if (found == document.end() || *found != format) return "it is no session: 'format' is not \"mien session\"";
  const std::string fault = versionFault(document);
  if (fault.empty()) session = std::move(document);
  return fault;
}

std::string writeSession(const json& session) {
  ordered document = {{"format", format}, {"version", sessionVersion}};
  for (const auto& item : session.items()) document[item.key()] = item.value();
  return document.dump(1, ' ', false, ordered::error_handler_t::replace) + "\n";
}

json jsonDifference(const json& from, const json& to) {
  if (!from.is_object() || !to.is_object()) return to;
  json patch = json::object();
  for (const auto& item : from.items())
    if (!to.contains(item.key())) patch[item.key()] = nullptr;
  for (const auto& item : to.items()) {
    const auto before = from.find(item.key());
    if (before == from.end())
      patch[item.key()] = item.value();
    else if (*before != item.value())
      patch[item.key()] = jsonDifference(*before, item.value());
  }
  return patch;
}

}  // namespace mien
