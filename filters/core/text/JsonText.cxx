#include "JsonText.h"

#include <algorithm>

namespace mien {

void refuse(const std::string& what) {
  throw std::invalid_argument(what);
}

void refuseUnknownKeys(const Json& json, std::initializer_list<const char*> known) {
  if (!json.is_object()) refuse("an object {...} is needed where there is " + std::string(json.type_name()));
  for (const auto& [key, value] : json.items())
    if (std::find(known.begin(), known.end(), key) == known.end()) refuse("the key \"" + key + "\" is unknown");
}

bool isKnownVersion(const Json& version, int newest) {
  return version.is_number_integer() && version >= 1 && version <= newest;
}

std::string plainText(const Json::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.find("] ");
  return end == std::string::npos ? text : text.substr(end + 2);
}

std::string parseJson(const std::string& text, const std::string& what, int& faultLine,
                      const std::function<void(const Json& root)>& parse) {
  faultLine = 0;
  try {
    parse(Json::parse(text));
  } catch (const Json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    faultLine = 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
    return what + ": it is no valid JSON from here on; look for a missing comma, quote or bracket";
  } catch (const Json::exception& error) {
    return what + ": " + plainText(error);
  } catch (const std::invalid_argument& error) {
    return what + ": " + error.what();
  }
  return {};
}

}  // namespace mien
