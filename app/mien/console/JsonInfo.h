#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// What a .json file of Mien's is, its version, and what takes it: sessions, states of a face, animation tables, maps
/// of facial actions and of regions, studies. Null for other files; throws a FileFailure when a .json is none of these.
nlohmann::ordered_json describeJsonFile(const std::string& file);
void printJsonFile(const nlohmann::ordered_json& about);

}  // namespace mien
