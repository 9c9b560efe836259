#include "FaceOptions.h"

#include <CLI/CLI.hpp>
#include <tuple>

#include "Arguments.h"
#include "DataFile.h"
#include "FacePipeline.h"
#include "FaceScheme.h"
#include "Failure.h"
#include "MovementText.h"
#include "OutputFile.h"
#include "TableList.h"

namespace mien {

namespace {

constexpr const char* paintedTexture = "painted";

std::string schemeHelp() {
  std::string names;
  for (const FaceScheme& scheme : faceSchemes()) names += (names.empty() ? "" : ", ") + scheme.name;
  return "How patches are closed: " + names + " [" + FaceState().surface.scheme + "]";
}

}  // namespace

void FaceOptions::addSurfaceOptions(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const std::string& help) {
    command.add_option(name, value, help)->group("Face");
  };
  add("--face", face_, "Boundary curves, FILE.vtp or .mienz [the generic face]");
  add("--scheme", scheme_, schemeHelp());
  add("-a,--smoothing", smoothing_, "Smoothing parameter a, 0 < a <= 1000: one value, or nine with commas [1]");
  add("-N,--harmonics", harmonics_, "Fourier modes solved exactly, 0 .. K/2 [5]");
  command.add_flag("--no-remainder", noRemainder_, "Leave out the harmonics above N")->group("Face");
  add("--resolution", resolution_, resolutionHelp());
  command.add_flag("--uniform-rows", uniformRows_, "Rows at equal u, not dealt to the curves")->group("Face");
  add("--derivative-strength", derivativeStrength_, "Factor on derivative conditions [1]");
  add("--precision", precision_, "single or double [single]");
}

void FaceOptions::addAnimationOptions(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->group("Animation")->check(isNotEmpty);
  };
  CLI::Option* fap = add("--fap", fap_, "Facial animation parameters, FILE.fap; the first frame without a choice");
  CLI::Option* frame = add("--frame", frame_, "Frame number as written in the file")->needs(fap);
  CLI::Option* index = add("--index", index_, "Frame counted from 0")->needs(fap)->excludes(frame);
  add("--time", time_, "Time in seconds")->needs(fap)->excludes(frame)->excludes(index);
  addMovementOptions(command);
}

void FaceOptions::addMovementOptions(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->group("Animation")->check(isNotEmpty);
  };
  add("--expression", expression_, "Expressions with intensities 0 .. 1, such as joy:0.8 or joy:0.6,surprise:0.4");
  add("--viseme", viseme_,
      "Visemes by name or number 1 .. 14 with strengths 0 .. 1: p_b_m, 10:0.5, or two that blend as in FAP 1, A:0.7,U");
  add("--set", set_,
      "FAP values by number or name, such as 53=200,54=200 or open_jaw=300; they add to those of a file");
  CLI::Option* fdt =
      add("--fdt", deformation_,
          "Facial deformation tables TABLE[:STRENGTH][,TABLE[:STRENGTH] ..], strengths -2 .. 2; a TABLE is FILE.csv, "
          "FILE.fdt or joy, sadness, anger, fear, disgust, surprise, smile, and several add up");
  command.add_flag("--fdt-hard", hardRegions_, "Every point follows the table's nearest region alone, as in the paper")
      ->group("Animation")
      ->needs(fdt);
  add("--fat", animationTable_, "What each FAP moves, TABLE.json [the table compiled in]");
}

void FaceOptions::addTextureOptions(CLI::App& command) {
  command
      .add_option("--texture", texture_,
                  "Photograph on the skin, IMAGE or IMAGE:MESH.csv; painted: the one that comes with Mien")
      ->group("Face");
  command.add_option("--texture-mesh", textureMesh_, "Its warp mesh, MESH.csv [the .csv beside it]")->group("Face");
}

void FaceOptions::addAll(CLI::App& command) {
  addSurfaceOptions(command);
  addAnimationOptions(command);
}

std::string FaceOptions::resolutionHelp() const {
  const FaceState usual;
  const std::string size = std::to_string(defaultRows_) + "x" + std::to_string(defaultColumns_);
  const bool isUsual = defaultRows_ == usual.rows && defaultColumns_ == usual.columns;
  return "Rows x columns of the uv mesh [" + size + (isUsual ? "; shaded pictures 164x160]" : "]");
}

void FaceOptions::setDefaultResolution(int rows, int columns) {
  defaultRows_ = rows;
  defaultColumns_ = columns;
}

FaceState FaceOptions::state() const {
  FaceState state;
  state.curvesFile = face_.empty() ? defaultFace_ : face_;
  fillSurface(state);
  fillGrid(state);
  fillFrame(state);
  fillMovement(state);
  fillDeformation(state);
  fillTexture(state);
  return state;
}

void FaceOptions::fillSurface(FaceState& state) const {
  if (!scheme_.empty()) state.surface.scheme = scheme_;
  if (!harmonics_.empty()) state.surface.modes = parseWholeNumber("--harmonics", harmonics_);
  if (!derivativeStrength_.empty())
    state.surface.derivativeStrength = parseNumber("--derivative-strength", derivativeStrength_);
  state.surface.remainder = !noRemainder_;
  if (smoothing_.empty()) return;
  const std::vector<std::string> values = splitText(smoothing_, ',');
  auto& a = state.surface.smoothing;
  if (values.size() != 1 && values.size() != a.size())
    throw ValueFailure("-a has " + std::to_string(values.size()) + " values; give one, or one for each of the " +
                       std::to_string(a.size()) + " patches");
  for (size_t patch = 0; patch < a.size(); ++patch)
    a[patch] = parseNumber("-a", values[values.size() == 1 ? 0 : patch]);
}

void FaceOptions::fillGrid(FaceState& state) const {
  state.rows = defaultRows_;
  state.columns = defaultColumns_;
  if (!resolution_.empty()) std::tie(state.rows, state.columns) = parseSize("--resolution", resolution_);
  state.uniformRows = uniformRows_;
  if (!precision_.empty() && precision_ != "single" && precision_ != "double")
    throw ValueFailure("--precision '" + precision_ + "' is unknown; it is single or double");
  state.doublePrecision = precision_ == "double";
}

void FaceOptions::fillFrame(FaceState& state) const {
  state.fapFile = fap_;
  if (!frame_.empty()) {
    state.frameChoice = FaceState::FrameChoice::Number;
    state.frame = parseNumber("--frame", frame_);
  } else if (!index_.empty()) {
    state.frame = parseWholeNumber("--index", index_);
  } else if (!time_.empty()) {
    state.frameChoice = FaceState::FrameChoice::Time;
    state.frame = parseNumber("--time", time_);
  }
}

void FaceOptions::fillMovement(FaceState& state) const {
  if (!expression_.empty()) state.expressions = parseExpressions("--expression", expression_);
  if (!viseme_.empty()) state.visemes = parseVisemes("--viseme", viseme_);
  if (!set_.empty()) state.fapValues = parseFAPValues("--set", set_);
  state.animationTable = animationTable_;
}

void setTexture(const std::string& text, FaceState& state) {
  state.texture = text;
  const size_t colon = text.rfind(':');
  if (colon != std::string::npos && fileEnding(text) == "csv") {
    if (!state.textureMesh.empty()) throw ValueFailure("--texture and --texture-mesh both name a mesh; give one");
    state.texture = text.substr(0, colon);
    state.textureMesh = text.substr(colon + 1);
  }
  if (state.texture != paintedTexture) return;
  state.texture = findDataFile("textures/painted.png");
  if (state.texture.empty())
    throw FileFailure("textures/painted.png: the texture that comes with Mien is not installed; give an IMAGE");
}

void FaceOptions::fillTexture(FaceState& state) const {
  if (texture_.empty() && !textureMesh_.empty())
    throw ValueFailure("--texture-mesh belongs to a photograph; give --texture");
  state.textureMesh = textureMesh_;
  setTexture(texture_, state);
}

void FaceOptions::fillDeformation(FaceState& state) const {
  std::vector<WeightedName> tables;
  const std::string fault = parseTableList(deformation_, tables);
  if (!fault.empty()) throw ValueFailure("--fdt: " + fault);
  state.deformation.table = deformation_;
  if (tables.size() == 1) {
    state.deformation.table = tables[0].name;
    state.deformation.strength = tables[0].weight;
  }
  state.deformation.smooth = !hardRegions_;
}

void FaceOptions::apply(FacePipeline& pipeline) const {
  pipeline.setState(state());
  checkOrThrow(pipeline);
}

void checkOrThrow(FacePipeline& pipeline) {
  const std::string fileFault = pipeline.updateNeutralCurves();
  if (!fileFault.empty()) throw FileFailure(fileFault);
  const std::string valueFault = pipeline.describeValueFault();
  if (!valueFault.empty()) throw ValueFailure(valueFault);
}

void updateOrThrow(FacePipeline& pipeline) {
  const std::string fault = pipeline.update();
  if (!fault.empty()) throw FileFailure(fault);
}

}  // namespace mien
