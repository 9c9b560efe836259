#include "FacePipeline.h"

#include <algorithm>
#include <sstream>

#include "BoundaryCurveData.h"
#include "FAPSequence.h"
#include "FAPUnits.h"
#include "FaceLayout.h"
#include "PipelineErrors.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCurveEditFilter.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"
#include "vtkFDTCurveFilter.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFDTReader.h"
#include "vtkNew.h"
#include "vtkOrderedGeometryFilter.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPassThrough.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr int smallestAnimatedCurve = 32;  // points

bool isAnimated(const FaceState& state) {
  const auto moves = [](const auto& fap) { return fap.second != 0.0; };
  return !state.fapFile.empty() || !state.expressions.empty() || !state.visemes.empty() ||
         std::any_of(state.fapValues.begin(), state.fapValues.end(), moves);
}

/// Whether the face has the feature points and the number of points that animation needs.
bool canBeAnimated(vtkPolyData* curves) {
  FaceCurves face;
  FAPUnits units;
  return readFaceCurves(curves, face).empty() && measureFAPUnits(face, units).empty() &&
         face.curves.pointsPerCurve >= smallestAnimatedCurve;
}

double shareOf(const std::map<std::string, double>& shapes, const std::string& name) {
  const auto found = shapes.find(name);
  return found == shapes.end() ? 0.0 : found->second;
}

/// Which of the shapes chosen is none of those there are, or nothing.
std::string describeUnknown(const std::string& kind, const std::map<std::string, double>& chosen,
                            const std::vector<std::string>& names) {
  const auto isUnknown = [&](const auto& shape) {
    return std::find(names.begin(), names.end(), shape.first) == names.end();
  };
  const auto unknown = std::find_if(chosen.begin(), chosen.end(), isUnknown);
  if (unknown == chosen.end()) return {};
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return "there is no " + kind + " '" + unknown->first + "'; there are " + all;
}

}  // namespace

struct FacePipeline::Internals {
  FaceState state;
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkCurveEditFilter> edit;
  vtkNew<vtkFAPReader> frames;
  vtkNew<vtkFAPAnimationFilter> animation;
  vtkNew<vtkPassThrough> curves;
  vtkNew<vtkPDEFaceFilter> face;
  vtkNew<vtkFDTReader> table;
  vtkNew<vtkFDTDeformationFilter> deformation;
  vtkNew<vtkFDTCurveFilter> curveDeformation;
  vtkNew<vtkPassThrough> skin, shownCurves;
  vtkNew<vtkOrderedGeometryFilter> surface;
  PipelineErrors errors;

  Internals() {
    edit->SetInputConnection(reader->GetOutputPort());
    animation->SetInputConnection(edit->GetOutputPort());
    curves->SetInputConnection(animation->GetOutputPort());
    face->SetInputConnection(curves->GetOutputPort());
    deformation->SetInputConnection(face->GetOutputPort());
    deformation->SetTableConnection(table->GetOutputPort());
    curveDeformation->SetInputConnection(curves->GetOutputPort());
    curveDeformation->SetTableConnection(table->GetOutputPort());
    shownCurves->SetInputConnection(curves->GetOutputPort());
    skin->SetInputConnection(face->GetOutputPort());
    surface->SetInputConnection(skin->GetOutputPort());
    for (vtkAlgorithm* algorithm :
         std::initializer_list<vtkAlgorithm*>{reader, edit, frames, animation, curves, face, table, deformation,
                                              curveDeformation, shownCurves, skin, surface})
      errors.observe(algorithm);
  }

  /// A face without feature points is still a face: while nothing moves it goes around the animation. So does one that
  /// the table compiled in does not fit; a table that was asked for is told of.
  bool goesAround() {
    if (isAnimated(state) || !errors.first().empty()) return false;
    if (!canBeAnimated(reader->GetOutput())) return true;
    if (!state.animationTable.empty()) return false;
    edit->Update();
    if (!errors.first().empty()) return false;  // the face's own fault, not the table's
    animation->Update();
    const bool refused = !errors.first().empty();
    if (refused) {
      errors.clear();
      animation->Modified();  // else it would not look again
    }
    return refused;
  }

  void chooseCurves() {
    const bool around = this->goesAround();
    curves->SetInputConnection((around ? static_cast<vtkAlgorithm*>(edit) : animation)->GetOutputPort());
  }

  void setMotion() {
    frames->SetFileName(state.fapFile.empty() ? nullptr : state.fapFile.c_str());
    animation->SetFAPConnection(state.fapFile.empty() ? nullptr : frames->GetOutputPort());
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) {
      const auto found = state.fapValues.find(fap);
      animation->SetFAP(fap, found == state.fapValues.end() ? 0.0 : found->second);
    }
    for (const std::string& name : vtkFAPAnimationFilter::GetExpressionNames())
      animation->SetExpression(name, shareOf(state.expressions, name));
    for (const std::string& name : vtkFAPAnimationFilter::GetVisemeNames())
      animation->SetViseme(name, shareOf(state.visemes, name));
    animation->SetAnimationTableFileName(state.animationTable);
  }

  /// Makes the reader give the frame that the state chooses. @return nothing, or why there is none
  std::string chooseFrame() {
    if (state.fapFile.empty()) return {};
    using Choice = FaceState::FrameChoice;
    const bool mixed = state.frameChoice == Choice::Time && state.interpolateFrames;
    int index = static_cast<int>(std::min<double>(state.frame, frames->GetNumberOfFrames()));
    if (state.frameChoice == Choice::Number)
      index = frames->GetIndexOfFrameNumber(state.frame);
    else if (state.frameChoice == Choice::Time)
      index = static_cast<int>(frames->GetSequence().indexAtTime(state.frame));
    if (index < 0 || index >= frames->GetNumberOfFrames()) return this->describeMissingFrame();
    const FAPSequence& sequence = frames->GetSequence();
    // The last frame is shown for as long as the others.
    if (state.frameChoice == Choice::Time && state.frame >= sequence.duration() + 1.0 / sequence.framesPerSecond)
      return this->describeMissingTime();
    frames->SetInterpolate(mixed);
    frames->SetFrameIndex(mixed ? -1 : index);
    return {};
  }

  std::string describeMissingFrame() const {
    const std::vector<FAPFrame>& all = frames->GetSequence().frames;
    std::ostringstream text;
    text << state.fapFile << ": there is no frame ";
    if (state.frameChoice == FaceState::FrameChoice::Number)
      text << "with number " << state.frame << "; numbers run from " << all.front().number << " to "
           << all.back().number;
    else
      text << "with index " << state.frame << "; indices run from 0 to " << all.size() - 1;
    return text.str();
  }

  std::string describeMissingTime() const {
    std::ostringstream text;
    text << state.fapFile << ": there is no frame at " << state.frame << " s; the animation lasts from 0 to "
         << frames->GetSequence().duration() << " s";
    return text.str();
  }

  /// The table bends the surface between the face and what shows it.
  void setDeformation() {
    const FaceDeformation& chosen = state.deformation;
    const bool none = chosen.table.empty();
    table->SetFileName(none ? nullptr : chosen.table.c_str());
    deformation->SetStrength(chosen.strength);
    deformation->SetSmooth(chosen.smooth);
    curveDeformation->SetStrength(chosen.strength);
    curveDeformation->SetSmooth(chosen.smooth);
    shownCurves->SetInputConnection((none ? static_cast<vtkAlgorithm*>(curves) : curveDeformation)->GetOutputPort());
    skin->SetInputConnection((none ? static_cast<vtkAlgorithm*>(face) : deformation)->GetOutputPort());
  }

  void setGrid() {
    face->SetResolution(state.rows, state.columns);
    face->SetUniformRows(state.uniformRows);
    face->SetOutputPointsPrecision(state.doublePrecision ? vtkAlgorithm::DOUBLE_PRECISION
                                                         : vtkAlgorithm::SINGLE_PRECISION);
  }

  /// Reads the curves and what the animation file holds.
  std::string readInputs() {
    errors.clear();
    reader->Update();
    if (errors.first().empty() && !state.fapFile.empty()) frames->UpdateInformation();
    this->chooseCurves();
    return this->afterUpdate();
  }

  /// After a failure VTK does not run a filter again until it is modified.
  std::string afterUpdate() {
    const std::string fault = errors.first();
    if (!fault.empty()) {
      reader->Modified();
      edit->Modified();
      frames->Modified();
      animation->Modified();
      table->Modified();
    }
    return fault;
  }

  int pointsPerCurve() { return static_cast<int>(reader->GetOutput()->GetNumberOfPoints() / FaceLayout::curveCount); }

  std::string describeValueFault() {
    std::string fault = describeFault(state, this->pointsPerCurve());
    if (fault.empty())
      fault = describeUnknown("expression", state.expressions, vtkFAPAnimationFilter::GetExpressionNames());
    if (fault.empty()) fault = describeUnknown("viseme", state.visemes, vtkFAPAnimationFilter::GetVisemeNames());
    return fault.empty() ? this->chooseFrame() : fault;
  }

  /// Inputs are read and checked once, whatever is asked for.
  std::string update(std::initializer_list<vtkAlgorithm*> wanted) {
    std::string fault = this->readInputs();
    if (fault.empty()) fault = this->describeValueFault();
    if (!fault.empty()) return fault;
    const bool byTime = frames->GetFrameIndex() < 0 && !state.fapFile.empty();
    for (vtkAlgorithm* algorithm : wanted) {
      if (!errors.first().empty()) break;
      if (byTime)
        algorithm->UpdateTimeStep(state.frame);
      else
        algorithm->Update();
    }
    return this->afterUpdate();
  }
};

FacePipeline::FacePipeline() : Impl(new Internals) {
  this->setState({});
}

FacePipeline::~FacePipeline() = default;

void FacePipeline::setState(const FaceState& state) {
  this->Impl->state = state;
  this->Impl->reader->SetFileName(state.curvesFile.empty() ? nullptr : state.curvesFile.c_str());
  this->Impl->edit->SetEdits(state.edits);
  this->Impl->setMotion();
  this->Impl->face->SetParameters(state.surface);
  this->Impl->setGrid();
  this->Impl->setDeformation();
}

const FaceState& FacePipeline::state() const {
  return this->Impl->state;
}

vtkBoundaryCurveReader* FacePipeline::neutralCurves() const {
  return this->Impl->reader;
}

vtkFAPReader* FacePipeline::frames() const {
  return this->Impl->frames;
}

vtkFAPAnimationFilter* FacePipeline::animation() const {
  return this->Impl->animation;
}

vtkAlgorithm* FacePipeline::curves() const {
  return this->Impl->curves;
}

vtkAlgorithm* FacePipeline::shownCurves() const {
  return this->Impl->shownCurves;
}

vtkPDEFaceFilter* FacePipeline::face() const {
  return this->Impl->face;
}

vtkStructuredGrid* FacePipeline::grid() const {
  return vtkStructuredGrid::SafeDownCast(this->Impl->skin->GetOutputDataObject(0));
}

vtkAlgorithm* FacePipeline::surface() const {
  return this->Impl->surface;
}

std::string FacePipeline::updateNeutralCurves() {
  return this->Impl->readInputs();
}

std::string FacePipeline::describeValueFault() {
  return this->Impl->describeValueFault();
}

int FacePipeline::pointsPerCurve() const {
  return this->Impl->pointsPerCurve();
}

std::string FacePipeline::updateCurves() {
  return this->Impl->update({this->Impl->shownCurves});
}

std::string FacePipeline::updateGrid() {
  return this->Impl->update({this->Impl->skin});
}

std::string FacePipeline::update() {
  return this->Impl->update({this->Impl->surface, this->Impl->shownCurves});
}

}  // namespace mien
