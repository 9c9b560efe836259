#include "FaceStateJson.h"

#include <nlohmann/json.hpp>

#include "FaceStateText.h"

namespace mien {

nlohmann::json faceStateJson(const FaceState& state) {
  return nlohmann::json::parse(writeFaceState(state));
}

std::string readFaceState(const nlohmann::json& json, FaceState& state) {
  return readFaceState(json.dump(), state);
}

}  // namespace mien
