#pragma once

#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace mien {

using Json = nlohmann::json;

/// Ends the parsing of a JSON file (animation table, expressions, facial actions, region map) with what is wrong.
[[noreturn]] void refuse(const std::string& what);

/// A key that nobody reads is most likely misspelt, and its effect missing.
void refuseUnknownKeys(const Json& json, std::initializer_list<const char*> known);

bool isKnownVersion(const Json& version, int newest);  ///< a whole number from 1 to the newest

/// The sentence of a fault that the JSON library found, without its number.
std::string plainText(const Json::exception& error);

/// Runs one step of parsing; a fault is told with the name of what was being parsed.
template <typename Step>
void within(const std::string& place, Step&& step) {
  try {
    step();
  } catch (const Json::exception& error) {
    refuse(place + ": " + plainText(error));
  } catch (const std::invalid_argument& error) {
    refuse(place + ": " + error.what());
  }
}

/// Parses a whole text of `what` ("animation table").
/// @param[out] faultLine the line of a fault in the JSON itself, 0 for none or any other
/// @return nothing, or one sentence
std::string parseJson(const std::string& text, const std::string& what, int& faultLine,
                      const std::function<void(const Json& root)>& parse);

}  // namespace mien
