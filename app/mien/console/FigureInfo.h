#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// What a figure of Mien's (.svg .pdf .png) shows, and the command that made it. Null for other files; throws a
/// FileFailure when an .svg or .pdf is none of these.
nlohmann::ordered_json describeFigureFile(const std::string& file);
void printFigureFile(const nlohmann::ordered_json& about);

}  // namespace mien
