#pragma once

#include <string>
#include <vector>

namespace mien {

struct FaceState;

/// Names of the options of `mien` that describe a face, for those who read them and those who write them.
namespace faceOption {
constexpr const char* curves = "--face";
constexpr const char* scheme = "--scheme";
constexpr const char* smoothing = "-a";
constexpr const char* harmonics = "-N";
constexpr const char* noRemainder = "--no-remainder";
constexpr const char* derivativeStrength = "--derivative-strength";
constexpr const char* resolution = "--resolution";
constexpr const char* uniformRows = "--uniform-rows";
constexpr const char* precision = "--precision";
constexpr const char* fap = "--fap";
constexpr const char* frame = "--frame";
constexpr const char* index = "--index";
constexpr const char* time = "--time";
constexpr const char* interpolate = "--interpolate";
constexpr const char* expression = "--expression";
constexpr const char* viseme = "--viseme";
constexpr const char* set = "--set";
constexpr const char* deformation = "--fdt";
constexpr const char* hardRegions = "--fdt-hard";
constexpr const char* animationTable = "--fat";
constexpr const char* texture = "--texture";
constexpr const char* textureMesh = "--texture-mesh";
constexpr const char* state = "--state";
}  // namespace faceOption

/// The options that give this state, its numbers to the bit; what has no effect, such as the strength of no table, is
/// left out. Of a state that options cannot say, such as one with edits of curves or with a table or a mesh that is no
/// file, they are --state and its text form.
std::vector<std::string> faceArguments(const FaceState& state);

/// Arguments as a POSIX shell reads them back.
std::string shellText(const std::vector<std::string>& arguments);

}  // namespace mien
