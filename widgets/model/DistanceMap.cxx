#include "DistanceMap.h"

#include <vtkAlgorithm.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkSurfaceDistanceFilter.h>

#include <algorithm>
#include <memory>

#include "BackgroundTask.h"
#include "FaceModel.h"
#include "FilterProgress.h"
#include "PipelineErrors.h"
#include "RoundedUp.h"
#include "SurfaceDistance.h"

namespace mien {

namespace {

constexpr double leastRange = 0.5;  // mm: what two fits of one curve differ by is not stretched over the colours

/// For another thread, which alone refers to them (BackgroundTask).
struct Copies {
  vtkNew<vtkPolyData> face, scan;
};

}  // namespace

struct DistanceMap::Measured {
  vtkSmartPointer<vtkPolyData> map;
  DistanceSummary summary;
  std::string fault;
};

DistanceMap::DistanceMap(FaceModel* model, FaceView* view, QObject* parent)
    : QObject(parent), model_(model), task_(new BackgroundTask(this)), overlay_(view, tr("Curves and scan"), this) {
  connect(model_, &FaceModel::updated, this, &DistanceMap::follow);
  connect(&overlay_, &FaceOverlay::shownChanged, this, [this](bool shown) {
    if (!shown) setSubject(Subject::None);
  });
}

DistanceMap::~DistanceMap() {
  delete task_;
}

void DistanceMap::setScan(vtkPolyData* scan) {
  scan_ = scan;
  follow();
}

void DistanceMap::setSubject(Subject subject) {
  if (subject == subject_) return;
  subject_ = subject;
  automatic_ = 0.0;
  follow();
}

void DistanceMap::setFrontalOnly(bool on) {
  frontal_ = on;
  follow();
}

void DistanceMap::setLargest(double millimetres) {
  largest_ = millimetres;
  if (overlay_.isShown()) draw();
}

DistanceMap::Measured DistanceMap::measure(vtkPolyData* face, vtkPolyData* scan, bool frontal, int direction,
                                           const std::function<bool(double)>& goOn) {
  Measured measured;
  vtkNew<vtkSurfaceDistanceFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(face);
  filter->SetReferenceData(scan);
  filter->SetFrontalOnly(frontal);
  updateWith(goOn, filter);
  measured.fault = errors.first();
  measured.map = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(direction));
  measured.summary = filter->GetSummary(direction);
  return measured;
}

/// The thread has copies: the pipeline and the view go on using their own.
void DistanceMap::follow() {
  if (subject_ == Subject::None || !scan_) {
    task_->cancel();
    map_ = nullptr;
    summary_.clear();
    overlay_.hide();
    emit changed();
    return;
  }
  const auto copies = std::make_shared<Copies>();
  vtkNew<vtkReverseSense> outwards;  // where its normals point already; else it is lit from behind
  outwards->SetInputConnection(model_->pipeline().surface()->GetOutputPort());
  outwards->Update();
  copies->face->DeepCopy(outwards->GetOutput());
  copies->scan->DeepCopy(scan_);
  const int direction = subject_ == Subject::Face ? 0 : 1;
  task_->start(
      [this, copies, direction, frontal = frontal_](const BackgroundTask::Progress& goOn) -> std::function<void()> {
        const Measured measured = measure(copies->face, copies->scan, frontal, direction, goOn);
        return [this, measured] { take(measured); };
      },
      BackgroundTask::Before::Finishes);
}

void DistanceMap::take(const Measured& measured) {
  if (subject_ == Subject::None) return;
  if (!measured.fault.empty()) {
    emit model_->failed(tr("There is no distance map: %1").arg(QString::fromStdString(measured.fault)), QString());
    setSubject(Subject::None);
    return;
  }
  map_ = measured.map;
  summary_ = tr("%1%2: RMS %3 mm, median %4 mm, 95th percentile %5 mm, largest %6 mm")
                 .arg(subject_ == Subject::Face ? tr("Shown face to scan") : tr("Scan to shown face"))
                 .arg(frontal_ ? tr(", front only") : QString())
                 .arg(measured.summary.rms, 0, 'f', 2)
                 .arg(measured.summary.median, 0, 'f', 2)
                 .arg(measured.summary.percentile95, 0, 'f', 2)
                 .arg(measured.summary.maximum, 0, 'f', 2);
  automatic_ = std::max({automatic_, leastRange, roundedUp(measured.summary.percentile95)});
  draw();
  emit changed();
}

void DistanceMap::draw() {
  const bool onFace = subject_ == Subject::Face;
  overlay_.setSubject(tr("Distance"));
  overlay_.showSurface(map_, "Distance",
                       {onFace ? tr("Distance to the scan (mm)") : tr("Distance to the face (mm)"), 0.0,
                        largest_ > 0.0 ? largest_ : automatic_, FaceOverlay::Colors::Sequential});
}

}  // namespace mien
