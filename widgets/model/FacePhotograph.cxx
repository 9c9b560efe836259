#include "FacePhotograph.h"

#include <vtkBoundaryCurveReader.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <QDateTime>
#include <QFileInfo>
#include <filesystem>
#include <utility>

#include "FaceModel.h"
#include "FaceTexture.h"
#include "FaceView.h"
#include "ImageFile.h"
#include "ImagePicture.h"
#include "InlineText.h"
#include "WarpMeshText.h"
#include "WholeFile.h"

namespace mien {

namespace {

constexpr int screenSide = 1600;                      // pixels of the picture that the mesh is drawn over
constexpr int smallSide = 640;                        // of the photograph that follows the hand
constexpr int smallWidth = 512, smallHeight = 256;    // of its texture
constexpr int smallestWhole = 1;                      // steps that a mesh as opened has
constexpr double readShare = 0.4, reduceShare = 0.7;  // of the time that opening takes

QDateTime timeOf(const std::string& file) {
  return QFileInfo(QString::fromStdString(file)).lastModified();
}

/// Whether a .csv is a warp mesh and no list of landmarks, told by its first line.
bool isMesh(const QString& fileName) {
  QFile file(fileName);
  if (!file.open(QIODevice::ReadOnly)) return true;  // reading it as a mesh says what is wrong
  QByteArray line;
  while (!file.atEnd() && (line.isEmpty() || line.startsWith('#'))) line = file.readLine(1000).trimmed();
  return line.startsWith("mien_warp_mesh");
}

}  // namespace

struct FacePhotograph::Photograph {
  std::string file;
  QDateTime time;
  vtkNew<vtkImageData> whole, small;
  QImage picture;

  std::string read(const std::string& name, const Progress& progress) {
    file = name;
    time = timeOf(name);
    std::string fault = readImageFile(name, whole);
    if (!fault.empty()) return fault;
    vtkNew<vtkImageData> screen;
    goesOn(progress, readShare);
    fault = reduceImage(whole, screenSide, partOf(progress, readShare, reduceShare), screen);
    if (fault.empty()) fault = reduceImage(screen, smallSide, partOf(progress, reduceShare, 1.0), small);
    if (fault.empty()) picture = pictureOf(screen);
    return fault.empty() ? fault : name + ": " + fault;
  }

  bool isOf(const std::string& name) const { return file == name && time == timeOf(name); }
};

FacePhotograph::FacePhotograph(FaceModel* model, FaceView* view, QObject* parent)
    : QObject(parent), model_(model), view_(view), task_(new BackgroundTask(this)) {
  connect(model, &FaceModel::stateChanged, this, &FacePhotograph::follow);
  connect(task_, &BackgroundTask::progressed, this, &FacePhotograph::progressed);
  connect(task_, &BackgroundTask::runningChanged, this, &FacePhotograph::runningChanged);
  asked_.curves = good_.curves = model->state().curvesFile;
  follow();
}

/// The task is ended first: what it still delivers must find the photograph whole.
FacePhotograph::~FacePhotograph() {
  delete task_;
}

FacePhotograph::Names FacePhotograph::named() const {
  const FaceState& state = model_->state();
  return {state.texture, state.textureMesh, state.curvesFile};
}

/// A copy, for another thread.
vtkSmartPointer<vtkPolyData> FacePhotograph::curves() const {
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  model_->pipeline().neutralCurves()->Update();
  copy->DeepCopy(model_->pipeline().neutralCurves()->GetOutput());
  return copy;
}

const QImage& FacePhotograph::picture() const {
  static const QImage none;
  return photograph_ ? photograph_->picture : none;
}

void FacePhotograph::open(const QString& image, const QString& mesh) {
  uncovers_ = !image.isEmpty();
  model_->change([&](FaceState& state) {
    state.texture = image.toStdString();
    state.textureMesh = mesh.toStdString();
  });
  if (!reading_) uncover();
}

/// Only what the user has opened: a session has its own colours, and undo those of the step.
void FacePhotograph::uncover() {
  if (std::exchange(uncovers_, false)) view_->showOverlay(nullptr, true);
}

bool FacePhotograph::isOn() const {
  return !model_->state().texture.empty();
}

void FacePhotograph::setOn(bool on) {
  if (on == isOn()) return;
  const Names back = off_;
  open(on ? QString::fromStdString(back.image) : QString(), on ? QString::fromStdString(back.mesh) : QString());
}

void FacePhotograph::follow() {
  const Names names = named();
  if (names == asked_) return;
  asked_ = names;
  if (!names.image.empty()) return read();
  task_->cancel();
  reading_ = false;
  if (!good_.image.empty()) off_ = good_;
  good_ = names;
  view_->setTexture(nullptr);
  emit opened();
}

void FacePhotograph::read() {
  reading_ = true;
  task_->start([this, names = asked_, curves = curves(),
                known = photograph_](const BackgroundTask::Progress& goOn) -> std::function<void()> {
    auto photograph = known;
    std::string fault;
    if (!known || !known->isOf(names.image)) {
      photograph = std::make_shared<Photograph>();
      fault = photograph->read(names.image, goOn);
    }
    const std::string beside = meshBeside(names.image), file = names.mesh.empty() ? beside : names.mesh;
    const int* size = photograph->whole->GetDimensions();
    WarpMesh mesh;
    if (fault.empty() && names.mesh.empty() && !std::filesystem::exists(beside))
      fault = makeStartingMesh(curves, size[0], size[1], mesh);
    else if (fault.empty())
      fault = readSourceMesh(file, mesh);
    if (!fault.empty()) return [this, fault] { refuse(fault); };
    return [this, names, photograph, mesh = scaledMesh(mesh, size[0], size[1])] { accept(names, photograph, mesh); };
  });
}

void FacePhotograph::accept(const Names& names, const std::shared_ptr<Photograph>& photograph, const WarpMesh& mesh) {
  reading_ = false;
  if (names.image != good_.image) landmarks_.clear();
  good_ = names;
  uncover();
  photograph_ = photograph;
  mesh_ = mesh;
  const bool started = names.mesh.empty() && !std::filesystem::exists(meshBeside(names.image));
  steps_ = {{mesh_, good_.mesh}};
  if (started) name(writeWarpMesh(mesh_));
  emit opened();
  emit meshChanged();
  warp(false);
  if (started)
    emit model_->remarked(tr("%1 has no mesh beside it; move the points of the mesh to where the features lie, or give "
                             "landmarks.")
                              .arg(QFileInfo(QString::fromStdString(names.image)).fileName()),
                          QString());
  if (!waiting_.isEmpty()) openMesh(std::exchange(waiting_, QString()));
}

/// The face is as it was before, and so is the state.
void FacePhotograph::refuse(const std::string& fault) {
  takeBack();
  model_->update();  // first, as a state that is good clears what failed before it
  emit model_->failed(QString::fromStdString(fault), tr("The face is as it was before."));
}

void FacePhotograph::takeBack() {
  reading_ = uncovers_ = false;
  waiting_.clear();
  asked_.image = good_.image;
  asked_.mesh = good_.mesh;
  model_->change([this](FaceState& state) {
    state.texture = good_.image;
    state.textureMesh = good_.mesh;
  });
  emit opened();
}

/// What was shown stays: of a photograph that was being read nothing, of one that was being warped its small version.
void FacePhotograph::cancel() {
  task_->cancel();
  if (reading_) takeBack();
}

void FacePhotograph::openMesh(const QString& file) {
  if (reading_) return void(waiting_ = file);
  if (!photograph_ || !isOn()) return;
  WarpMesh mesh;
  const int* size = photograph_->whole->GetDimensions();
  const bool landmarks = !isMesh(file);
  using Kind = FaceWarpLayout::Kind;
  const std::string fault = landmarks ? readLandmarkMesh(file.toStdString(), fine_ ? Kind::Fine : Kind::SevenBySeven,
                                                         curves(), size[0], size[1], mesh)
                                      : readSourceMesh(file.toStdString(), mesh);
  if (!fault.empty()) return model_->failed(QString::fromStdString(fault), tr("The mesh is as it was before."));
  landmarks_ = landmarks ? file : QString();
  mesh_ = scaledMesh(mesh, size[0], size[1]);
  landmarks ? finishMove() : takeMesh(mesh_, file.toStdString());
}

void FacePhotograph::setFine(bool fine) {
  fine_ = fine;
  if (!landmarks_.isEmpty()) openMesh(landmarks_);
}

QString FacePhotograph::move(MeshNode node, double x, double y, bool mirrored) {
  if (!photograph_) return {};
  const QString fault = QString::fromStdString(moveNode(mesh_, node, x, y, mirrored));
  if (!fault.isEmpty()) return fault;
  emit meshChanged();
  warp(false);
  return {};
}

void FacePhotograph::finishMove() {
  if (steps_.empty() || mesh_ == steps_.back().first) return;
  takeMesh(mesh_, writeWarpMesh(mesh_));
}

void FacePhotograph::takeMesh(const WarpMesh& mesh, const std::string& named) {
  mesh_ = mesh;
  steps_.emplace_back(mesh_, named);
  name(named);
  emit meshChanged();
  warp(false);
}

/// How the state names the mesh that is already shown: as a file, or by its text.
void FacePhotograph::name(const std::string& mesh) {
  asked_.mesh = good_.mesh = mesh;
  if (!steps_.empty()) steps_.back().second = mesh;
  model_->change([&](FaceState& state) { state.textureMesh = mesh; });
}

bool FacePhotograph::save(const QString& fileName) {
  if (!photograph_) return false;
  const std::string fault = WholeFile::write(fileName.toStdString(), writeWarpMesh(mesh_));
  if (!fault.empty()) {
    emit model_->failed(fileName + ": " + QString::fromStdString(fault), QString());
    return false;
  }
  name(fileName.toStdString());
  emit meshChanged();
  emit model_->remarked(tr("%1 was written.").arg(QFileInfo(fileName).fileName()), fileName);
  return true;
}

bool FacePhotograph::isSaved() const {
  return !isInlineText(good_.mesh);
}

void FacePhotograph::undo() {
  if (!canUndo()) return;
  steps_.pop_back();
  const Step step = steps_.back();
  steps_.pop_back();
  takeMesh(step.first, step.second);
}

void FacePhotograph::reset() {
  if (!canUndo()) return;
  steps_.resize(smallestWhole + 1);
  undo();
}

/// Small textures follow each other while the hand moves; the whole one is made when the last small one is there, and
/// gives way to the next small one.
void FacePhotograph::warp(bool whole) {
  task_->start(
      [this, photograph = photograph_, mesh = mesh_, curves = curves(),
       whole](const BackgroundTask::Progress& goOn) -> std::function<void()> {
        auto texture = vtkSmartPointer<vtkImageData>::New();
        const std::string fault = warpFaceTexture(whole ? photograph->whole : photograph->small, mesh, curves,
                                                  whole ? faceTextureWidth : smallWidth,
                                                  whole ? faceTextureHeight : smallHeight, goOn, texture);
        const QImage picture = fault.empty() ? pictureOf(texture) : QImage();
        return [this, fault, texture, picture, whole] {
          if (!fault.empty()) return refuseMesh(fault);
          warped_ = picture;
          dress(texture, whole);
        };
      },
      warpsWhole_ ? BackgroundTask::Before::Ends : BackgroundTask::Before::Finishes);
  warpsWhole_ = whole;
}

/// A mesh can cross itself between its points, which only the warp finds.
void FacePhotograph::refuseMesh(const std::string& fault) {
  emit refused(QString::fromStdString(fault));
  if (isMoving()) return;
  undo();
  model_->update();
  emit model_->failed(QString::fromStdString(fault), tr("The mesh is as it was before."));
}

bool FacePhotograph::isMoving() const {
  return steps_.empty() || !(mesh_ == steps_.back().first);
}

void FacePhotograph::dress(vtkImageData* texture, bool whole) {
  view_->setTexture(isOn() ? texture : nullptr);
  emit refused(QString());
  emit warpedChanged();
  if (!whole && !isMoving()) warp(true);
}

}  // namespace mien
