#include "FileOpener.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QTimer>
#include <algorithm>
#include <iterator>

#include "Comparison.h"
#include "FaceModel.h"
#include "ScanPanel.h"
#include "TexturePanel.h"

namespace mien {

namespace {

constexpr int patience = 3000;  // ms; most scans are measured by then, and none that is no scan opens a dock

}  // namespace

struct FileOpener::Action {
  FileKind kind;
  bool (FileOpener::*open)(const QString& fileName);
  const char* dock;     ///< that shows it; nullptr: none
  const char* endings;  ///< in the dialogue
};

const FileOpener::Action FileOpener::actions[] = {
    {FileKind::Curves, &FileOpener::openCurves, nullptr, "*.vtp *.mienz"},
    {FileKind::Scan, &FileOpener::openScan, "curvesDock", "*.ply *.obj *.stl *.off"},
    {FileKind::Landmarks, &FileOpener::openScanLandmarks, "curvesDock", "*.csv"},
    {FileKind::Mesh, &FileOpener::openMesh, nullptr, "*.vts"},
    {FileKind::Photograph, &FileOpener::openPhotograph, "textureDock", "*.png *.jpg *.jpeg *.tif *.tiff"},
    {FileKind::PhotographMesh, &FileOpener::openPhotographMesh, "textureDock", "*.csv"},
};

FileOpener::FileOpener(FaceModel* model, QMainWindow* window) : QObject(window), model_(model), window_(window) {
  const auto* scan = window->findChild<ScanPanel*>();
  connect(scan, &ScanPanel::scanChanged, this, [this, scan] {
    if (scan->hasScan()) show("curvesDock");
  });
  const auto* texture = window->findChild<TexturePanel*>();
  connect(texture, &TexturePanel::opened, this, [this, texture] {
    if (texture->fileName() == photograph_) show("textureDock");
  });
  connect(model, &FaceModel::failed, this, [this] { awaited_.clear(); });
}

bool FileOpener::opens(FileKind kind) {
  return std::any_of(std::begin(actions), std::end(actions), [kind](const Action& a) { return a.kind == kind; });
}

bool FileOpener::open(FileKind kind, const QString& fileName) {
  const auto action =
      std::find_if(std::begin(actions), std::end(actions), [kind](const Action& a) { return a.kind == kind; });
  if (action == std::end(actions)) return false;
  awaited_ = action->dock;
  return (this->*action->open)(fileName);
}

QString FileOpener::endings() {
  QStringList all;
  for (const Action& action : actions)
    for (const QString& ending : QString(action.endings).split(' '))
      if (!all.contains(ending)) all += {ending, ending.toUpper()};
  return all.join(' ');
}

/// As by the View menu, so that the dock gets the height it has there.
void FileOpener::show(const QString& dock) {
  if (awaited_ != dock) return;
  awaited_.clear();
  auto* shown = window_->findChild<QDockWidget*>(dock);
  if (shown->isHidden()) shown->toggleViewAction()->trigger();
  shown->raise();
}

bool FileOpener::openCurves(const QString& fileName) {
  if (!model_->openCurves(fileName)) return false;
  emit model_->remarked(tr("%1 is the face now.").arg(QFileInfo(fileName).fileName()), fileName);
  return true;
}

/// What is wrong with it is known once it is measured. Of a large one the dock shows how far that is.
bool FileOpener::openScan(const QString& fileName) {
  auto* panel = window_->findChild<ScanPanel*>();
  panel->open(fileName);
  if (!panel->isVisible())
    emit model_->remarked(
        tr("%1 is being measured; the dock Curves and scan tells how far that is. File > Close scan ends it.")
            .arg(QFileInfo(fileName).fileName()),
        QString());
  QTimer::singleShot(patience, this, [this, panel] {
    if (panel->isMeasuring()) show("curvesDock");
  });
  return true;
}

bool FileOpener::succeeds(const std::function<void()>& act) {
  bool good = true;
  const auto listening = connect(model_, &FaceModel::failed, this, [&good] { good = false; });
  act();
  disconnect(listening);
  return good;
}

bool FileOpener::openScanLandmarks(const QString& fileName) {
  auto* panel = window_->findChild<ScanPanel*>();
  const bool waits = !panel->isMeasuring() && !panel->hasScan();
  if (waits) awaited_.clear();
  panel->openLandmarks(fileName);
  if (waits)
    emit model_->remarked(
        tr("%1 holds landmarks of a scan; they are used once a scan is opened.").arg(QFileInfo(fileName).fileName()),
        fileName);
  return true;
}

bool FileOpener::openMesh(const QString& fileName) {
  return window_->findChild<Comparison*>()->openMesh(fileName);
}

bool FileOpener::openPhotograph(const QString& fileName) {
  auto* panel = window_->findChild<TexturePanel*>();
  photograph_ = fileName;
  panel->open(fileName);
  if (panel->fileName() == fileName) show("textureDock");  // it is open already
  return true;
}

bool FileOpener::openPhotographMesh(const QString& fileName) {
  if (model_->state().texture.empty()) {
    emit model_->failed(tr("%1 says where features lie on a photograph, and none is open; open the photograph first.")
                            .arg(QFileInfo(fileName).fileName()),
                        fileName);
    return false;
  }
  if (!succeeds([&] { window_->findChild<TexturePanel*>()->open(fileName); })) return false;
  show("textureDock");
  return true;
}

}  // namespace mien
