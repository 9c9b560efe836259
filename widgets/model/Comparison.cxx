#include "Comparison.h"

#include <vtkAlgorithm.h>
#include <vtkDoubleArray.h>
#include <vtkMotionVectorFilter.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSurfaceDistanceFilter.h>

#include <QFileInfo>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "BackgroundTask.h"
#include "CoveredParts.h"
#include "FaceModel.h"
#include "FaceScheme.h"
#include "FaceStateJson.h"
#include "FilterProgress.h"
#include "LengthUnit.h"
#include "MeshReading.h"
#include "PipelineErrors.h"
#include "SurfaceDistance.h"
#include "SurfaceMesh.h"

namespace mien {

namespace {

using json = nlohmann::json;

constexpr const char* kindNames[] = {"none", "state", "scheme", "mesh"};

/// In mm with hundredths, of large distances with what four digits hold.
QString distanceNumber(double distance) {
  return QString::number(distance, 'f', distance < 100.0 ? 2 : distance < 1000.0 ? 1 : 0);
}

QString numbersText(const DistanceSummary& summary) {
  return Comparison::tr("RMS %1, 95 % \u2264 %2, max %3 mm")
      .arg(distanceNumber(summary.rms), distanceNumber(summary.percentile95), distanceNumber(summary.maximum));
}

/// Copies a surface and gives it an array under another name.
vtkSmartPointer<vtkPolyData> withArrays(vtkPolyData* surface, vtkDataArray* distances, vtkDataArray* vectors) {
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  const std::pair<const char*, vtkDataArray*> arrays[] = {{"Distance", distances}, {"DistanceVector", vectors}};
  for (const auto& [name, array] : arrays) {
    vtkNew<vtkDoubleArray> named;
    named->ShallowCopy(array);
    named->SetName(name);
    copy->GetPointData()->AddArray(named);
  }
  return copy;
}

/// A scan without normals would look like a cut stone.
vtkSmartPointer<vtkPolyData> withNormals(const vtkSmartPointer<vtkPolyData>& surface) {
  if (surface->GetPointData()->GetNormals()) return surface;
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

/// A head is once to three times as long as the face; what is read in mm may have been written in another unit.
QString doubtOfUnit(const QString& name, double mesh, double face) {
  if (mesh > face / 4.0 && mesh < 4.0 * face) return {};
  const std::vector<LengthUnit> units = unitsThatFit(mesh, 0.7 * face, 3.0 * face);
  if (units.empty()) return {};
  return Comparison::tr(
             "%1 is %2 mm from end to end as it is read, the face %3 mm: it may be in %4, and the distances "
             "wrong; the dock Curves and scan reads and places scans in any unit")
      .arg(name, QString::number(mesh, 'g', 3), QString::number(face, 'g', 3),
           QString::fromStdString(units.front().fullName));
}

DistanceSummary summaryOf(vtkPolyData* surface) {
  vtkDataArray* array = surface->GetPointData()->GetArray("Distance");
  std::vector<double> distances(array->GetNumberOfTuples());
  for (size_t i = 0; i < distances.size(); ++i) distances[i] = array->GetComponent(i, 0);
  const std::vector<double> areas = pointAreas(trianglesOf(surface));
  return summarize(distances, areas, [&](size_t i) { return areas[i] > 0.0; });
}

}  // namespace

struct Comparison::Distances {
  Surfaces surfaces, drawn;
  std::array<DistanceSummary, 2> summaries;
  bool corresponds = false, covered = false;  ///< whether the summaries are of what lies opposite the other alone
  std::string fault;
};

Comparison::Comparison(FaceModel* model, QObject* parent)
    : QObject(parent), model_(model), task_(new BackgroundTask(this)) {
  setObjectName("comparison");
  connect(model_, &FaceModel::updated, this, &Comparison::follow);
}

Comparison::~Comparison() {
  delete task_;
}

FaceModel* Comparison::other() {
  if (other_) return other_;
  other_ = new FaceModel(this);
  connect(other_, &FaceModel::failed, model_, &FaceModel::failed);
  return other_;
}

vtkPolyData* Comparison::mesh() const {
  return kind_ == Kind::Mesh ? mesh_.Get() : nullptr;
}

vtkPolyData* Comparison::surface(Side side) const {
  return measured_[static_cast<int>(side)];
}

QString Comparison::name() const {
  return kind_ == Kind::Scheme ? inScheme(scheme_) : kind_ == Kind::Mesh ? QFileInfo(file_).fileName() : words_;
}

QString Comparison::nameOfA() const {
  if (kind_ == Kind::Scheme) return inScheme(QString::fromStdString(model_->state().surface.scheme));
  const std::string words = model_->motionText();
  return words.empty() ? tr("the neutral face") : QString::fromStdString(words);
}

/// Both faces stand as A does.
QString Comparison::inScheme(const QString& scheme) const {
  const std::string words = model_->motionText();
  return tr("%1, %2").arg(scheme, words.empty() ? tr("neutral") : QString::fromStdString(words));
}

bool Comparison::corresponds() const {
  return distances_ && distances_->corresponds;
}

vtkPolyData* Comparison::drawn(Side side) const {
  return distances_ ? distances_->drawn[static_cast<int>(side)] : nullptr;
}

bool Comparison::leavesOut() const {
  return distances_ && distances_->covered;
}

QString Comparison::summary(Side side) const {
  if (!distances_) return {};
  const int index = static_cast<int>(side);
  const DistanceSummary& summary = distances_->summaries[index];
  const vtkIdType all = std::max<vtkIdType>(1, distances_->surfaces[index]->GetNumberOfPoints());
  QString what = side == Side::A ? tr("A to B") : tr("B to A");
  if (corresponds()) what = side == Side::A ? tr("Point to point, by area of A") : tr("Point to point, by area of B");
  const QString counted = side == Side::A ? tr(", %1 % of A") : tr(", %1 % of B");
  if (leavesOut()) what += counted.arg(100.0 * summary.points / all, 0, 'f', 0);
  return tr("%1: %2").arg(what, numbersText(summary));
}

void Comparison::take(Kind kind) {
  kind_ = kind;
  task_->cancel();
  measured_ = {};
  distances_.reset();
  follow();
  emit changed();
}

void Comparison::pin() {
  const std::string words = model_->motionText();
  words_ = words.empty() ? tr("the neutral face") : QString::fromStdString(words);
  const FaceState state = model_->lastingState();
  other()->change([&](FaceState& pinned) { pinned = state; });
  if (other()->update()) take(Kind::State);
}

void Comparison::pin(const FaceState& state) {
  other()->change([&](FaceState& pinned) { pinned = state; });
  if (!other()->update()) return;
  const std::string words = other()->motionText();
  words_ = words.empty() ? tr("the neutral face") : QString::fromStdString(words);
  take(Kind::State);
}

void Comparison::compareScheme(const QString& scheme) {
  const std::vector<FaceScheme>& known = faceSchemes();
  const std::string name = scheme.toStdString();
  if (std::none_of(known.begin(), known.end(), [&](const FaceScheme& one) { return one.name == name; }))
    return emit model_->failed(tr("There is no scheme '%1' to compare with.").arg(scheme), QString());
  scheme_ = scheme;
  take(Kind::Scheme);
}

bool Comparison::openMesh(const QString& fileName) {
  vtkSmartPointer<vtkDataObject> read;
  const std::string fault = readSurfaceFile(fileName.toStdString(), read);
  if (!fault.empty()) {
    emit model_->failed(QString::fromStdString(fault), tr("What A is compared with stays as it was."));
    return false;
  }
  mesh_ = withNormals(visibleSurface(read));
  file_ = fileName;
  take(Kind::Mesh);
  auto* face = vtkPolyData::SafeDownCast(model_->pipeline().surface()->GetOutputDataObject(0));
  const QString doubt = doubtOfUnit(name(), mesh_->GetLength(), face->GetLength());
  if (!doubt.isEmpty()) emit model_->failed(doubt, fileName);
  return true;
}

void Comparison::swap() {
  if (kind_ == Kind::Scheme) {
    const QString shown = QString::fromStdString(model_->state().surface.scheme);
    const std::string wanted = scheme_.toStdString();
    scheme_ = shown;
    model_->change([&](FaceState& state) { state.surface.scheme = wanted; });
  } else if (kind_ == Kind::State) {
    const FaceState b = other()->state();
    pin();
    model_->change([&](FaceState& state) { state = b; });
  } else {
    return;
  }
  model_->update();
  emit changed();
}

void Comparison::clear() {
  if (kind_ != Kind::None) take(Kind::None);
}

/// B is brought up to date first, so that both are of one moment.
void Comparison::follow() {
  if (kind_ == Kind::None) return;
  if (kind_ == Kind::Scheme) {
    FaceState state = model_->lastingState();
    state.surface.scheme = scheme_.toStdString();
    other()->change([&](FaceState& followed) { followed = state; });
    other()->update();
  }
  measure();
}

Comparison::Surfaces Comparison::present() const {
  Surfaces surfaces;
  const auto surfaceOf = [](const FaceModel& face) {
    return vtkPolyData::SafeDownCast(face.pipeline().surface()->GetOutputDataObject(0));
  };
  surfaces[0] = surfaceOf(*model_);
  surfaces[1] = kind_ == Kind::Mesh ? mesh_.Get() : surfaceOf(*other_);
  return surfaces;
}

void Comparison::measure() {
  const Surfaces surfaces = present();
  if (!measureCounterparts(surfaces)) measureNearest(surfaces);
}

/// Quick enough for the thread of the window. @return whether points and cells are the same
bool Comparison::measureCounterparts(const Surfaces& surfaces) {
  if (surfaces[0]->GetNumberOfPoints() != surfaces[1]->GetNumberOfPoints()) return false;
  Distances distances;
  distances.corresponds = true;
  for (int side = 0; side < 2; ++side) {
    vtkNew<vtkMotionVectorFilter> filter;
    PipelineErrors errors;
    errors.observe(filter);
    filter->SetInputData(surfaces[1 - side]);
    filter->SetNeutralData(surfaces[side]);
    filter->Update();
    if (!errors.first().empty()) return false;
    vtkPointData* data = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
    distances.surfaces[side] = withArrays(surfaces[side], data->GetArray("Magnitude"), data->GetArray("MotionVector"));
    distances.drawn[side] = distances.surfaces[side];
    distances.summaries[side] = summaryOf(distances.surfaces[side]);
  }
  task_->cancel();  // what it still measures is of surfaces that are gone
  deliver(distances);
  return true;
}

/// A scan has a neck and a crown that no face reaches: with `covered` the numbers leave them out, which is impossible
/// where nothing of one lies opposite the other.
Comparison::Distances Comparison::nearest(const Surfaces& surfaces, bool covered,
                                          const std::function<bool(double)>& goOn) {
  Distances distances;
  distances.covered = covered;
  vtkNew<vtkSurfaceDistanceFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(surfaces[0]);
  filter->SetReferenceData(surfaces[1]);
  filter->GenerateVectorsOn();
  filter->SetCoveredOnly(covered);
  if (!updateWith(partOf(goOn, 0.0, 0.7), filter)) return distances;
  distances.fault = errors.first();
  for (int side = 0; side < 2 && distances.fault.empty(); ++side) {
    distances.surfaces[side] = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(side));
    distances.drawn[side] = coveredApart(distances.surfaces[side], partOf(goOn, 0.7 + 0.15 * side, 0.85 + 0.15 * side));
    distances.summaries[side] = filter->GetSummary(side);
  }
  return distances;
}

/// The thread has copies: the pipelines and the views go on using their own.
void Comparison::measureNearest(const Surfaces& surfaces) {
  const auto copies = std::make_shared<Surfaces>();  // which the thread alone refers to (BackgroundTask)
  for (int side = 0; side < 2; ++side) {
    (*copies)[side] = vtkSmartPointer<vtkPolyData>::New();
    (*copies)[side]->DeepCopy(surfaces[side]);
  }
  task_->start(
      [this, copies, isMesh = kind_ == Kind::Mesh](const BackgroundTask::Progress& goOn) -> std::function<void()> {
        const auto distances = std::make_shared<Distances>();
        if (isMesh) *distances = nearest(*copies, true, goOn);
        if (!isMesh || !distances->fault.empty()) *distances = nearest(*copies, false, goOn);
        return [this, distances] { deliver(*distances); };
      },
      BackgroundTask::Before::Finishes);
}

void Comparison::deliver(const Distances& distances) {
  if (kind_ == Kind::None) return;
  if (!distances.fault.empty()) {
    emit model_->failed(tr("A and B cannot be compared: %1").arg(QString::fromStdString(distances.fault)), name());
    return clear();
  }
  measured_ = distances.surfaces;
  distances_ = std::make_unique<Distances>(distances);
  emit measured();
}

json Comparison::sessionState() const {
  json state = {{"kind", kindNames[static_cast<int>(kind_)]}};
  if (kind_ == Kind::State) state["state"] = faceStateJson(other_->state());
  if (kind_ == Kind::Scheme) state["scheme"] = scheme_.toStdString();
  if (kind_ == Kind::Mesh) state["file"] = file_.toStdString();
  return state;
}

void Comparison::restoreSession(const json& state) {
  const auto text = [&](const char* name) {
    const auto found = state.find(name);
    return found != state.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const std::string kind = state.is_object() ? text("kind") : std::string();
  if (kind == "scheme") return compareScheme(QString::fromStdString(text("scheme")));
  if (kind == "mesh") return void(openMesh(QString::fromStdString(text("file"))));
  if (kind != "state") return clear();
  FaceState pinned;
  const auto found = state.find("state");
  const std::string fault = readFaceState(found == state.end() ? json() : *found, pinned);
  if (fault.empty()) return pin(pinned);
  emit model_->failed(tr("B cannot be shown: %1").arg(QString::fromStdString(fault)), QString());
}

}  // namespace mien
