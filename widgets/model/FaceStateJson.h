#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mien {

struct FaceState;

/// The text form of a FaceState as a JSON object.
/// @sa writeFaceState
nlohmann::json faceStateJson(const FaceState& state);

/// @return nothing, or one sentence that names the member at fault; the state is then as it was
std::string readFaceState(const nlohmann::json& json, FaceState& state);

}  // namespace mien
