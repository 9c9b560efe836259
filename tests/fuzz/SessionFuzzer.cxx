#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "FaceState.h"
#include "FaceStateText.h"
#include "InlineText.h"
#include "Require.h"
#include "SessionText.h"
#include "WarpMeshText.h"

using namespace mien;

namespace {

/// A mesh over a photograph that was not saved as a file is part of the state.
void checkMesh(const std::string& text) {
  WarpMesh mesh, again;
  if (!isInlineText(text) || !parseWarpMesh(text, mesh).empty()) return;
  require(mesh.x.allFinite() && mesh.y.allFinite());
  require(parseWarpMesh(writeWarpMesh(mesh), again).empty() && again == mesh);
}

}  // namespace

/// What is read can be written and read again, and every session leads to every other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  nlohmann::json session;
  const std::string fault = readSession(std::string(reinterpret_cast<const char*>(data), size), session);
  require(fault.empty() == !session.is_null());
  if (!fault.empty()) return 0;
  require(session.is_object());
  nlohmann::json again;
  require(readSession(writeSession(session), again).empty());
  nlohmann::json led = {{"face", 1}};
  led.merge_patch(jsonDifference(led, again));
  if (session.contains("face")) {
    FaceState state;
    readFaceState(session["face"].dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), state);
    checkMesh(state.textureMesh);
  }
  return 0;
}
