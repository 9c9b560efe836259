#include "FaceArguments.h"

#include <algorithm>
#include <cmath>

#include "FaceState.h"
#include "FaceStateText.h"
#include "InlineText.h"
#include "NumberText.h"

namespace mien {

namespace {

using Choice = FaceState::FrameChoice;
using Arguments = std::vector<std::string>;

/// Whether --fdt takes the table as one name and not as a list or a text.
bool isOneName(const std::string& table) {
  return table.find_first_of(":,\n") == std::string::npos;
}

/// For what no option says, and names that options read in another way.
bool needsWholeState(const FaceState& state) {
  const bool mixesFrames = state.interpolateFrames && state.frameChoice != Choice::Time;
  return !state.edits.empty() || (mixesFrames && !state.fapFile.empty()) || !isOneName(state.deformation.table) ||
         state.texture.find(':') != std::string::npos || state.texture == "painted" ||
         isInlineText(state.textureMesh) || state.fapFile == "-";
}

class Writer {
 public:
  void add(const char* option, const std::string& value) {
    if (value.empty()) return;
    arguments_.push_back(option);
    arguments_.push_back(value);
  }
  void flag(const char* option, bool on) {
    if (on) arguments_.push_back(option);
  }
  Arguments take() { return std::move(arguments_); }

 private:
  Arguments arguments_;
};

std::string smoothingText(const FaceState& state) {
  const auto& a = state.surface.smoothing;
  std::string text = numberText(a.front());
  const bool uniform = std::all_of(a.begin(), a.end(), [&](double value) { return value == a.front(); });
  for (size_t patch = 1; patch < a.size() && !uniform; ++patch) appendNumber(text += ',', a[patch]);
  return a == FaceState().surface.smoothing ? std::string() : text;
}

void addSurface(const FaceState& state, Writer& out) {
  const FaceState none;
  const FaceSurfaceOptions& surface = state.surface;
  if (surface.scheme != none.surface.scheme) out.add(faceOption::scheme, surface.scheme);
  out.add(faceOption::smoothing, smoothingText(state));
  if (surface.modes != none.surface.modes) out.add(faceOption::harmonics, std::to_string(surface.modes));
  out.flag(faceOption::noRemainder, !surface.remainder);
  if (surface.derivativeStrength != none.surface.derivativeStrength)
    out.add(faceOption::derivativeStrength, numberText(surface.derivativeStrength));
}

/// Always with its resolution, as pictures have another one by themselves.
void addGrid(const FaceState& state, Writer& out) {
  out.add(faceOption::resolution, std::to_string(state.rows) + "x" + std::to_string(state.columns));
  out.flag(faceOption::uniformRows, state.uniformRows);
  if (state.doublePrecision) out.add(faceOption::precision, "double");
}

void addFrame(const FaceState& state, Writer& out) {
  if (state.fapFile.empty()) return;
  out.add(faceOption::fap, state.fapFile);
  const char* const option = state.frameChoice == Choice::Number  ? faceOption::frame
                             : state.frameChoice == Choice::Index ? faceOption::index
                                                                  : faceOption::time;
  const bool isIndex = state.frameChoice == Choice::Index;
  out.add(option, isIndex ? std::to_string(std::llround(state.frame)) : numberText(state.frame));
  out.flag(faceOption::interpolate, state.interpolateFrames);
}

template <class Values, class Name>
std::string listed(const Values& values, char between, const Name& nameOf) {
  std::string text;
  for (const auto& [key, value] : values) {
    text += (text.empty() ? "" : ",") + nameOf(key) + between;
    appendNumber(text, value);
  }
  return text;
}

void addMovement(const FaceState& state, Writer& out) {
  const auto written = [](std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  };
  out.add(faceOption::expression, listed(state.expressions, ':', [](const std::string& name) { return name; }));
  out.add(faceOption::viseme, listed(state.visemes, ':', written));
  out.add(faceOption::set, listed(state.fapValues, '=', [](int fap) { return std::to_string(fap); }));
  out.add(faceOption::animationTable, state.animationTable);
}

void addDeformation(const FaceDeformation& deformation, Writer& out) {
  if (deformation.table.empty()) return;
  std::string text = deformation.table;
  if (deformation.strength != 1.0) appendNumber(text += ':', deformation.strength);
  out.add(faceOption::deformation, text);
  out.flag(faceOption::hardRegions, !deformation.smooth);
}

}  // namespace

std::vector<std::string> faceArguments(const FaceState& state) {
  if (needsWholeState(state)) return {faceOption::state, writeFaceState(state)};
  Writer out;
  out.add(faceOption::curves, state.curvesFile);
  addSurface(state, out);
  addGrid(state, out);
  addFrame(state, out);
  addMovement(state, out);
  addDeformation(state.deformation, out);
  out.add(faceOption::texture, state.texture);
  if (!state.texture.empty()) out.add(faceOption::textureMesh, state.textureMesh);
  return out.take();
}

std::string shellText(const std::vector<std::string>& arguments) {
  const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  std::string text;
  for (const std::string& argument : arguments) {
    text += text.empty() ? "" : " ";
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) {
      text += argument;
      continue;
    }
    text += '\'';
    for (char c : argument) c == '\'' ? void(text += "'\\''") : void(text += c);
    text += '\'';
  }
  return text;
}

}  // namespace mien
