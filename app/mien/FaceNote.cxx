#include "FaceNote.h"

#include <algorithm>
#include <filesystem>

#include "CsvText.h"

namespace mien {

namespace {

/// The state that a figure carries has the whole path.
std::string fileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

bool hasUniformSmoothing(const FaceSurfaceOptions& options) {
  const double first = options.smoothing.front();
  return std::all_of(options.smoothing.begin(), options.smoothing.end(), [first](double a) { return a == first; });
}

std::string faceNote(const FaceState& state, const std::vector<std::string>& schemes, bool withSmoothing) {
  const FaceSurfaceOptions& surface = state.surface;
  std::string text = state.curvesFile.empty() ? "Generic face" : fileName(state.curvesFile);
  text += schemes.size() == 1 ? ", scheme " : ", schemes ";
  for (size_t i = 0; i < schemes.size(); ++i) text += (i ? ", " : "") + schemes[i];
  if (withSmoothing) {
    text += "; a = ";
    for (size_t patch = 0; patch < (hasUniformSmoothing(surface) ? 1 : surface.smoothing.size()); ++patch)
      text += (patch ? ", " : "") + shortestText(surface.smoothing[patch]);
  }
  text += "; N = " + std::to_string(surface.modes) + (surface.remainder ? " with remainder" : " without remainder");
  if (!state.fapFile.empty()) text += "; " + fileName(state.fapFile);
  for (const auto& [name, strength] : state.visemes) text += "; viseme " + name + " at " + shortestText(strength);
  for (const auto& [name, intensity] : state.expressions) text += "; " + name + " at " + shortestText(intensity);
  return text + "; Mien " MIEN_VERSION;
}

}  // namespace mien
