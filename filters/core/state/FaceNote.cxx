#include "FaceNote.h"

#include <algorithm>

#include "Counted.h"
#include "NumberText.h"
#include "TableTitle.h"

namespace mien {

namespace {

/// The state that a figure carries has the whole path.
std::string fileName(const std::string& path) {
  if (path == "-") return "standard input";
  return path.substr(path.find_last_of("/\\") + 1);
}

std::string text(double value) {
  std::string text;
  appendNumber(text, value);
  return text;
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string all;
  for (const std::string& part : parts) all += (all.empty() ? "" : between) + part;
  return all;
}

std::string frameText(const FaceState& state) {
  switch (state.frameChoice) {
    case FaceState::FrameChoice::Number:
      return "frame " + text(state.frame);
    case FaceState::FrameChoice::Index:
      return "frame at index " + text(state.frame);
    case FaceState::FrameChoice::Time:
      break;
  }
  return text(state.frame) + " s" + (state.interpolateFrames ? ", interpolated," : "");
}

std::string valuesText(const std::map<int, double>& values, size_t most) {
  if (values.size() > most) return counted(values.size(), "FAP value");
  std::vector<std::string> parts;
  for (const auto& [fap, value] : values) parts.push_back("FAP " + std::to_string(fap) + " = " + text(value));
  return joined(parts, ", ");
}

std::string weighted(const std::string& name, double weight) {
  return weight == 1.0 ? name : name + " at " + text(weight);
}

std::string deformationText(const FaceDeformation& deformation) {
  return weighted("deformation table " + fileName(tableTitle(deformation.table)), deformation.strength) +
         (deformation.smooth ? "" : " in hard regions");
}

std::string smoothingText(const FaceSurfaceOptions& surface) {
  std::vector<std::string> parts;
  for (const double a : surface.smoothing) parts.push_back(text(a));
  if (hasUniformSmoothing(surface)) parts.resize(1);
  return "a = " + joined(parts, ", ");
}

std::string curvesText(const FaceState& state, const std::vector<std::string>& schemes) {
  std::string words = state.curvesFile.empty() ? "Generic face" : fileName(state.curvesFile);
  if (!state.edits.empty()) words += " with " + counted(state.edits.size(), "edit") + " of curves";
  return words + (schemes.size() == 1 ? ", scheme " : ", schemes ") + joined(schemes, ", ");
}

}  // namespace

bool hasUniformSmoothing(const FaceSurfaceOptions& options) {
  const double first = options.smoothing.front();
  return std::all_of(options.smoothing.begin(), options.smoothing.end(), [first](double a) { return a == first; });
}

std::string motionText(const FaceState& state, const std::string& frames, size_t mostFAPs) {
  std::vector<std::string> parts;
  if (!state.fapFile.empty())
    parts.push_back((frames.empty() ? frameText(state) : frames) + " of " + fileName(state.fapFile));
  for (const auto& [name, intensity] : state.expressions) parts.push_back(weighted(name, intensity));
  for (const auto& [name, strength] : state.visemes) parts.push_back("viseme " + weighted(name, strength));
  if (!state.fapValues.empty()) parts.push_back(valuesText(state.fapValues, mostFAPs));
  if (!state.deformation.table.empty()) parts.push_back(deformationText(state.deformation));
  return joined(parts, ", ");
}

std::string faceNote(const FaceState& state, const std::vector<std::string>& schemes, bool withSmoothing,
                     const std::string& frames) {
  const FaceSurfaceOptions& surface = state.surface;
  std::vector<std::string> parts = {curvesText(state, schemes)};
  if (withSmoothing) parts.push_back(smoothingText(surface));
  parts.push_back("N = " + std::to_string(surface.modes) +
                  (surface.remainder ? " with remainder" : " without remainder"));
  if (surface.derivativeStrength != FaceSurfaceOptions().derivativeStrength)
    parts.push_back("derivative strength " + text(surface.derivativeStrength));
  if (!state.animationTable.empty()) parts.push_back("animation table " + fileName(state.animationTable));
  const std::string motion = motionText(state, frames);
  if (!motion.empty()) parts.push_back(motion);
  parts.push_back("Mien " MIEN_VERSION);
  return joined(parts, "; ");
}

}  // namespace mien
