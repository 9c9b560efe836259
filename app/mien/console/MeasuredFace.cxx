#include "MeasuredFace.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "Arguments.h"
#include "FaceNote.h"
#include "FacePipeline.h"
#include "FaceScheme.h"
#include "Failure.h"
#include "Remarks.h"
#include "vtkPDEFaceAlgorithm.h"

namespace mien {

namespace {

std::string allSchemeNames() {
  std::string names;
  for (const FaceScheme& scheme : faceSchemes()) names += (names.empty() ? "" : ", ") + scheme.name;
  return names;
}

}  // namespace

MeasuredFace::MeasuredFace() : pipeline_(std::make_unique<FacePipeline>()) {}

MeasuredFace::~MeasuredFace() = default;

void MeasuredFace::addTo(CLI::App& command) {
  options_.addAll(command);
  command.remove_option(command.get_option("--scheme"));
  const std::string help = "How patches are closed: " + allSchemeNames() + ", a list of these with commas, or all [" +
                           FaceState().surface.scheme + "]";
  command.add_option("--scheme", scheme_, help)->group("Face");
}

void MeasuredFace::addWithoutSmoothing(CLI::App& command) {
  addTo(command);
  command.remove_option(command.get_option("--smoothing"));
}

void MeasuredFace::chooseSchemes() {
  schemes_.clear();
  if (scheme_ == "all") {
    for (const FaceScheme& scheme : faceSchemes()) schemes_.push_back(scheme.name);
    return;
  }
  schemes_ = splitText(scheme_.empty() ? FaceState().surface.scheme : scheme_, ',');
  for (const std::string& name : schemes_)
    if (!findFaceScheme(name))
      throw ValueFailure("--scheme '" + name + "' is unknown; the known ones are " + allSchemeNames() + ", and all");
}

void MeasuredFace::update() {
  chooseSchemes();
  options_.apply(*pipeline_);
  updateCurves();
}

void MeasuredFace::set(const FaceState& state, const std::vector<std::string>& schemes) {
  schemes_ = schemes;
  pipeline_->setState(state);
  checkOrThrow(*pipeline_);
  updateCurves();
}

void MeasuredFace::updateCurves() {
  const std::string fault = pipeline_->updateCurves();
  if (!fault.empty()) throw FileFailure(fault);
  printRemarks(*pipeline_);
}

const FaceState& MeasuredFace::state() const {
  return pipeline_->state();
}

void MeasuredFace::connect(vtkPDEFaceAlgorithm* filter, const std::string& scheme) const {
  FaceSurfaceOptions surface = state().surface;
  surface.scheme = scheme;
  filter->SetInputConnection(pipeline_->curves()->GetOutputPort());
  filter->SetParameters(surface);
}

nlohmann::ordered_json MeasuredFace::description(const std::string& scheme) const {
  const FaceSurfaceOptions& surface = state().surface;
  nlohmann::ordered_json about;
  about["scheme"] = scheme;
  if (hasUniformSmoothing(surface))
    about["a"] = surface.smoothing.front();
  else
    about["a"] = surface.smoothing;
  about["modes"] = surface.modes;
  about["remainder"] = surface.remainder;
  return about;
}

std::string MeasuredFace::note(bool withSmoothing) const {
  return faceNote(state(), schemes_, withSmoothing);
}

}  // namespace mien
