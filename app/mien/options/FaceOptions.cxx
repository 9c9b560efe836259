#include "FaceOptions.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <tuple>

#include "Arguments.h"
#include "DataFile.h"
#include "FaceArguments.h"
#include "FacePipeline.h"
#include "FaceScheme.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "FigureMetadata.h"
#include "FigureOptions.h"
#include "MovementText.h"
#include "OutputFile.h"
#include "SessionText.h"
#include "TableList.h"
#include "TextFileReader.h"

namespace mien {

namespace {

constexpr const char* paintedTexture = "painted";

std::string schemeHelp() {
  std::string names;
  for (const FaceScheme& scheme : faceSchemes()) names += (names.empty() ? "" : ", ") + scheme.name;
  return "How patches are closed: " + names + " [" + FaceState().surface.scheme + "]";
}

/// Of a .json file, or of a figure that carries one.
std::string readStateText(const std::string& file, std::string& text) {
  if (!FigureOptions::isFigure(file)) return readTextFile(file, largestSessionText, text, "face state");
  FigureMetadata figure;
  const std::string fault = figure.read(file);
  if (!fault.empty()) throw FileFailure(fault);
  text = figure.state();
  return text.empty() ? "the figure carries no state of a face; give one that does, or a .json file" : "";
}

}  // namespace

void FaceOptions::addSurfaceOptions(CLI::App& command) {
  const auto add = [&](const std::string& name, std::string& value, const std::string& help) {
    command.add_option(name, value, help)->group("Face");
  };
  add(faceOption::curves, face_, "Boundary curves, FILE.vtp or .mienz [the generic face]");
  add(faceOption::scheme, scheme_, schemeHelp());
  add(std::string(faceOption::smoothing) + ",--smoothing", smoothing_,
      "Smoothing parameter a, 0 < a <= 1000: one value, or nine with commas [1]");
  add(std::string(faceOption::harmonics) + ",--harmonics", harmonics_, "Fourier modes solved exactly, 0 .. K/2 [5]");
  command.add_flag(faceOption::noRemainder, noRemainder_, "Leave out the harmonics above N")->group("Face");
  add(faceOption::resolution, resolution_, resolutionHelp());
  command.add_flag(faceOption::uniformRows, uniformRows_, "Rows at equal u, not dealt to the curves")->group("Face");
  add(faceOption::derivativeStrength, derivativeStrength_, "Factor on derivative conditions [1]");
  add(faceOption::precision, precision_, "single or double [single]");
  add(faceOption::state, state_,
      "The face of a figure (.svg .pdf .png) or a session (.json), or the JSON that Copy as command gives; other "
      "options change it");
}

void FaceOptions::addAnimationOptions(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->group("Animation")->check(isNotEmpty);
  };
  CLI::Option* fap =
      add(faceOption::fap, fap_, "Facial animation parameters, FILE.fap; the first frame without a choice");
  CLI::Option* frame = add(faceOption::frame, frame_, "Frame number as written in the file")->needs(fap);
  CLI::Option* index = add(faceOption::index, index_, "Frame counted from 0")->needs(fap)->excludes(frame);
  CLI::Option* time = add(faceOption::time, time_, "Time in seconds")->needs(fap)->excludes(frame)->excludes(index);
  command.add_flag(faceOption::interpolate, interpolates_, "A time between two frames gives their linear mixture")
      ->group("Animation")
      ->needs(time);
  addMovementOptions(command);
}

void FaceOptions::addMovementOptions(CLI::App& command) {
  const auto add = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->group("Animation")->check(isNotEmpty);
  };
  add(faceOption::expression, expression_,
      "Expressions with intensities 0 .. 1, such as joy:0.8 or joy:0.6,surprise:0.4");
  add(faceOption::viseme, viseme_,
      "Visemes by name or number 1 .. 14 with strengths 0 .. 1: p_b_m, 10:0.5, or two that blend as in FAP 1, A:0.7,U");
  add(faceOption::set, set_,
      "FAP values by number or name, such as 53=200,54=200 or open_jaw=300; they add to those of a file");
  CLI::Option* fdt =
      add(faceOption::deformation, deformation_,
          "Facial deformation tables TABLE[:STRENGTH][,TABLE[:STRENGTH] ..], strengths -2 .. 2; a TABLE is FILE.csv, "
          "FILE.fdt or joy, sadness, anger, fear, disgust, surprise, smile, and several add up");
  command
      .add_flag(faceOption::hardRegions, hardRegions_,
                "Every point follows the table's nearest region alone, as in the paper")
      ->group("Animation")
      ->needs(fdt);
  add(faceOption::animationTable, animationTable_, "What each FAP moves, TABLE.json [the table compiled in]");
}

void FaceOptions::addTextureOptions(CLI::App& command) {
  command
      .add_option(faceOption::texture, texture_,
                  "Photograph on the skin, IMAGE or IMAGE:MESH.csv; painted: the one that comes with Mien")
      ->group("Face");
  command.add_option(faceOption::textureMesh, textureMesh_, "Its warp mesh, MESH.csv [the .csv beside it]")
      ->group("Face");
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

/// The generic face, or what --state says.
FaceState FaceOptions::start() const {
  FaceState state;
  state.curvesFile = defaultFace_;
  state.rows = defaultRows_;
  state.columns = defaultColumns_;
  if (state_.empty()) return state;
  const bool isText = state_.find_first_not_of(" \t\n") == state_.find('{');
  std::string text = state_, fault;
  if (!isText) fault = readStateText(state_, text);
  nlohmann::json session;
  if (fault.empty()) fault = readSession(text, session);
  if (fault.empty() && !session.contains("face")) fault = "the member 'face' is missing";
  if (fault.empty()) fault = readFaceState(session["face"].dump(), state);
  if (fault.empty()) fault = describeFault(state.surface, 2 * std::max(0, state.surface.modes));
  if (fault.empty()) return state;
  if (isText) throw ValueFailure(std::string(faceOption::state) + ": " + fault);
  throw FileFailure(state_ + (fault.front() == ' ' ? ":" : ": ") + fault);
}

FaceState FaceOptions::state() const {
  FaceState state = start();
  if (!face_.empty()) state.curvesFile = face_;
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
    state.surface.derivativeStrength = parseNumber(faceOption::derivativeStrength, derivativeStrength_);
  if (noRemainder_) state.surface.remainder = false;
  if (smoothing_.empty()) return;
  const std::vector<std::string> values = splitText(smoothing_, ',');
  auto& a = state.surface.smoothing;
  if (values.size() != 1 && values.size() != a.size())
    throw ValueFailure("-a has " + std::to_string(values.size()) + " values; give one, or one for each of the " +
                       std::to_string(a.size()) + " patches");
  for (size_t patch = 0; patch < a.size(); ++patch)
    a[patch] = parseNumber(faceOption::smoothing, values[values.size() == 1 ? 0 : patch]);
}

void FaceOptions::fillGrid(FaceState& state) const {
  if (!resolution_.empty()) std::tie(state.rows, state.columns) = parseSize(faceOption::resolution, resolution_);
  if (uniformRows_) state.uniformRows = true;
  if (precision_.empty()) return;
  if (precision_ != "single" && precision_ != "double")
    throw ValueFailure("--precision '" + precision_ + "' is unknown; it is single or double");
  state.doublePrecision = precision_ == "double";
}

/// Another file begins at its first frame.
void FaceOptions::fillFrame(FaceState& state) const {
  if (fap_.empty()) return;
  const FaceState none;
  state.fapFile = fap_;
  state.frameChoice = none.frameChoice;
  state.frame = none.frame;
  state.interpolateFrames = interpolates_;
  if (!frame_.empty()) {
    state.frameChoice = FaceState::FrameChoice::Number;
    state.frame = parseNumber(faceOption::frame, frame_);
  } else if (!index_.empty()) {
    state.frame = parseWholeNumber(faceOption::index, index_);
  } else if (!time_.empty()) {
    state.frameChoice = FaceState::FrameChoice::Time;
    state.frame = parseNumber(faceOption::time, time_);
  }
}

void FaceOptions::fillMovement(FaceState& state) const {
  if (!expression_.empty()) state.expressions = parseExpressions(faceOption::expression, expression_);
  if (!viseme_.empty()) state.visemes = parseVisemes(faceOption::viseme, viseme_);
  if (!set_.empty()) state.fapValues = parseFAPValues(faceOption::set, set_);
  if (!animationTable_.empty()) state.animationTable = animationTable_;
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
  if (texture_.empty()) return;
  state.textureMesh = textureMesh_;
  setTexture(texture_, state);
}

void FaceOptions::fillDeformation(FaceState& state) const {
  if (deformation_.empty()) return;
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
