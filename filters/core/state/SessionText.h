#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace mien {

/// Text form of a session of the application: a JSON object with the members `format` ("mien session"), `version`
/// (below), `face` (a FaceState, as FaceStateText writes it) and what the application keeps beside it.
constexpr int sessionVersion = 1;
constexpr std::size_t largestSessionText = 64 * 1024 * 1024;  ///< bytes; a session has about thirty thousand

/// Reads a session, or a bare FaceState, which becomes a session of nothing else. What is nested deeper than any
/// session is left out.
/// @return nothing, or what is wrong with it, as the end of a sentence; the session is then as it was
std::string readSession(const std::string& text, nlohmann::json& session);

/// With format and version in front.
std::string writeSession(const nlohmann::json& session);

/// What has to change for one document without null to become another, as an RFC 7396 merge patch:
/// from.merge_patch(jsonDifference(from, to)) gives to. Lists change as a whole. Equal documents differ by {}.
nlohmann::json jsonDifference(const nlohmann::json& from, const nlohmann::json& to);

}  // namespace mien
