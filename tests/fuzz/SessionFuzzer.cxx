#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "FaceState.h"
#include "FaceStateText.h"
#include "Require.h"
#include "SessionText.h"

using namespace mien;

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
  }
  return 0;
}
