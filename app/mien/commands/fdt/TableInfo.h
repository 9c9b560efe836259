#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// What a facial deformation table (.csv, .fdt) or a recording of markers (.csv) holds; null for any other file.
nlohmann::ordered_json describeTableFile(const std::string& name);

/// The same for reading.
void printTableFile(const nlohmann::ordered_json& about);

}  // namespace mien
