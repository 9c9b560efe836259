#include "FaceState.h"

#include <cmath>
#include <sstream>
#include <tuple>

#include "FAPFrame.h"
#include "GridResolution.h"

namespace mien {

namespace {

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

auto members(const FaceState& s) {
  return std::tie(s.curvesFile, s.edits, s.surface, s.rows, s.columns, s.uniformRows, s.doublePrecision, s.fapFile,
                  s.frameChoice, s.frame, s.interpolateFrames, s.animationTable, s.fapValues, s.expressions, s.visemes,
                  s.deformation, s.texture, s.textureMesh);
}

std::string describeEditFault(const FaceState& state, int pointsPerCurve) {
  for (size_t i = 0; i < state.edits.size(); ++i) {
    const std::string fault = describeFault(state.edits[i], pointsPerCurve);
    if (!fault.empty()) return "edit " + std::to_string(i + 1) + ": " + fault;
  }
  return {};
}

std::string describeFrameFault(const FaceState& state) {
  if (!std::isfinite(state.frame)) return "the frame is not a finite number";
  if (state.frameChoice == FaceState::FrameChoice::Index &&
      !(state.frame >= 0.0 && std::floor(state.frame) == state.frame))
    return "frame index " + number(state.frame) + " is no whole number from 0 up";
  if (state.frameChoice == FaceState::FrameChoice::Time && state.frame < 0.0)
    return "time " + number(state.frame) + " s lies before the first frame; times start at 0";
  return {};
}

std::string describeFAPFault(const FaceState& state) {
  for (const auto& [fap, value] : state.fapValues) {
    if (fap < FAPFrame::firstLowLevel || fap > FAPFrame::count)
      return "there is no low-level FAP " + std::to_string(fap) + "; they are " +
             std::to_string(FAPFrame::firstLowLevel) + " .. " + std::to_string(FAPFrame::count);
    if (!(std::abs(value) <= FaceState::largestFAPValue))
      return "FAP " + std::to_string(fap) + " = " + number(value) + " is outside -" +
             number(FaceState::largestFAPValue) + " .. " + number(FaceState::largestFAPValue);
  }
  return {};
}

std::string describeExpressionFault(const FaceState& state) {
  for (const auto& [name, intensity] : state.expressions)
    if (!(intensity >= 0.0 && intensity <= 1.0))
      return "expression intensity " + number(intensity) + " of " + name + " is outside 0 .. 1";
  return {};
}

std::string describeVisemeFault(const FaceState& state) {
  for (const auto& [name, strength] : state.visemes)
    if (!(strength >= 0.0 && strength <= 1.0))
      return "viseme strength " + number(strength) + " of " + name + " is outside 0 .. 1";
  if (state.visemes.size() <= FaceState::mostVisemes) return {};
  return std::to_string(state.visemes.size()) + " visemes are more than the two that mix";
}

std::string describeDeformationFault(const FaceState& state) {
  const double limit = FaceState::largestStrength;
  if (std::abs(state.deformation.strength) <= limit) return {};
  return "deformation strength " + number(state.deformation.strength) + " is outside -" + number(limit) + " .. " +
         number(limit);
}

}  // namespace

bool FaceDeformation::operator==(const FaceDeformation& other) const {
  return std::tie(table, strength, smooth) == std::tie(other.table, other.strength, other.smooth);
}

bool FaceState::operator==(const FaceState& other) const {
  return members(*this) == members(other);
}

std::string describeFault(const FaceState& state, int pointsPerCurve) {
  for (const std::string& fault :
       {describeFault(state.surface, pointsPerCurve),
        describeResolutionFault(state.rows, state.columns, RowLayout::minimumRows),
        describeEditFault(state, pointsPerCurve), describeFrameFault(state), describeFAPFault(state),
        describeExpressionFault(state), describeVisemeFault(state), describeDeformationFault(state)})
    if (!fault.empty()) return fault;
  return {};
}

}  // namespace mien
