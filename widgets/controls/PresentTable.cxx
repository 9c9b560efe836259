#include "PresentTable.h"

#include <vtkFDTFitFilter.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredGrid.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "BackgroundTask.h"
#include "DefaultRegions.h"
#include "FAPFrame.h"
#include "FDTData.h"
#include "FaceModel.h"
#include "FaceMotion.h"
#include "FaceNote.h"
#include "FaceStateJson.h"
#include "NamedTables.h"
#include "PipelineErrors.h"

namespace mien {

namespace {

std::vector<DeformationTable> means() {
  std::vector<DeformationTable> tables;
  for (const std::string& name : PresentTable::expressions()) tables.push_back(*namedTable(name));
  return tables;
}

PresentTable::Fit fitBetween(vtkStructuredGrid* before, vtkStructuredGrid* after) {
  vtkNew<vtkFDTFitFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(before);
  filter->SetExpressionData(after);
  filter->Update();
  PresentTable::Fit fit;
  std::string fault = errors.first();
  if (fault.empty()) fault = readFDT(filter->GetOutput(), fit.table);
  if (fault.empty()) fault = recognise(fit.table, defaultRegions(), means(), fit.scores);
  fit.fault = QString::fromStdString(fault);
  if (!fault.empty()) return fit;
  for (int i = 0; i < DeformationTable::regionCount; ++i) {
    fit.rms[i] = filter->GetOutput()->GetValueByName(i, "rms").ToDouble();
    fit.points[i] = filter->GetOutput()->GetValueByName(i, "points").ToInt();
  }
  fit.totalRms = filter->GetRMS();
  fit.warning = QString::fromStdString(filter->GetWarning());
  return fit;
}

/// Copies for another thread, which alone refers to them (BackgroundTask).
struct Grids {
  vtkSmartPointer<vtkStructuredGrid> before, after;
};

vtkSmartPointer<vtkStructuredGrid> copyOf(vtkStructuredGrid* grid) {
  auto copy = vtkSmartPointer<vtkStructuredGrid>::New();
  copy->DeepCopy(grid);
  return copy;
}

}  // namespace

bool PresentTable::Fit::moves() const {
  return table.largestDisplacement >= leastRecognisedMovement;
}

PresentTable::PresentTable(FaceModel* model, QObject* parent)
    : QObject(parent), model_(model), task_(new BackgroundTask(this)) {
  setObjectName("deformationPinned");
}

/// The task is ended first: what it still delivers must find this object whole.
PresentTable::~PresentTable() {
  delete task_;
}

const std::vector<std::string>& PresentTable::expressions() {
  static const auto names = [] {
    std::vector<std::string> result;
    for (const std::string& name : tableNames())
      if (namedTable(name)->deviations) result.push_back(name);
    return result;
  }();
  return names;
}

/// The frame of an animation is kept as FAPs, so that it stays when the animation goes on.
void PresentTable::pin() {
  pinned_ = model_->state();
  if (!pinned_->fapFile.empty() && model_->frameCount() > 0) {
    const double time = model_->framePosition() / model_->motion().framesPerSecond;
    const FAPFrame frame = model_->motion().frameAtTime(time, model_->interpolates());
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      if (frame.value(fap) != 0.0) pinned_->fapValues[fap] += frame.value(fap);
  }
  pinned_->fapFile.clear();
  request();
}

void PresentTable::unpin() {
  pinned_.reset();
  request();
}

nlohmann::json PresentTable::sessionState() const {
  if (!pinned_) return nlohmann::json::object();
  return {{"face", faceStateJson(*pinned_)}};
}

void PresentTable::restoreSession(const nlohmann::json& state) {
  FaceState face;
  const bool pins = state.is_object() && state.contains("face") && readFaceState(state["face"], face).empty();
  pinned_ = pins ? std::make_optional(face) : std::nullopt;
  request();
}

FaceState PresentTable::neutralState() const {
  FaceState state = FaceMotion::neutralOf(model_->state());
  if (pinned_) {
    state.fapValues = pinned_->fapValues;
    state.expressions = pinned_->expressions;
    state.visemes = pinned_->visemes;
    state.deformation = pinned_->deformation;
  }
  return state;
}

QString PresentTable::neutralText() const {
  if (!pinned_) return tr("the face at rest");
  const std::string motion = motionText(*pinned_);
  return motion.empty() ? tr("pinned at rest") : tr("pinned: %1").arg(QString::fromStdString(motion));
}

bool PresentTable::isOfPresentFace() const {
  return fit_ && fitted_ == model_->state();
}

void PresentTable::request() {
  neutral_.setState(neutralState());
  const std::string fault = neutral_.update();
  if (!fault.empty()) {
    fitted_ = model_->state();
    fit_.emplace();
    fit_->fault = QString::fromStdString(fault);
    emit changed();
    return;
  }
  const auto grids = std::make_shared<Grids>();
  grids->before = copyOf(neutral_.grid());
  grids->after = copyOf(model_->pipeline().grid());
  const auto work = [this, grids, state = model_->state()](const BackgroundTask::Progress&) -> std::function<void()> {
    const auto fit = std::make_shared<Fit>(fitBetween(grids->before, grids->after));
    return [this, fit, state] {
      fit_ = *fit;
      fitted_ = state;
      emit changed();
    };
  };
  task_->start(work, BackgroundTask::Before::Finishes);
}

}  // namespace mien
