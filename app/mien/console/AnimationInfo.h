#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace mien {

/// What a .fap file or a table of an animation holds: format, version, name, fps, frames, duration (s), first_frame,
/// last_frame, faps_used, faps_without_surface, warnings. Throws a FileFailure for a file that is none.
nlohmann::ordered_json describeAnimation(const std::string& file);

void printAnimation(const nlohmann::ordered_json& animation);

}  // namespace mien
