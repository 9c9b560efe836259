#include "StudioWindow.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QTabBar>
#include <QUrl>
#include <QVBoxLayout>

#include "AnimationPlayer.h"
#include "Autosave.h"
#include "BundledFile.h"
#include "CurveView.h"
#include "DockScroll.h"
#include "EditMenu.h"
#include "ExpressionPanel.h"
#include "FAPPanel.h"
#include "FaceColoring.h"
#include "FaceModel.h"
#include "FileDialog.h"
#include "FileMenu.h"
#include "FileOpener.h"
#include "FloatingBars.h"
#include "HelpMenu.h"
#include "History.h"
#include "LaboratoryDocks.h"
#include "LiveStream.h"
#include "MessageBar.h"
#include "RecentFiles.h"
#include "RecoveryBar.h"
#include "SessionDocument.h"
#include "SessionKeeper.h"
#include "SurfacePanel.h"
#include "TimelinePanel.h"
#include "ViewArea.h"
#include "ViewMenu.h"
#include "WindowLayout.h"
#include "Workspaces.h"

namespace mien {

namespace {

constexpr int studioWidth = 1280, studioHeight = 800;  // pixels
constexpr int titleBar = 40;                           // pixels that a desktop puts above a window

QStringList droppedFiles(const QMimeData* data) {
  QStringList names;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) names << url.toLocalFile();
  return names;
}

/// What to do with a file that is no use here, or nothing.
QString advice(FileKind kind) {
  switch (kind) {
    case FileKind::Markers:
      return StudioWindow::tr(
          "%1 holds markers before and after an expression. Fit a table to them, and open that: mien fdt fit %1 -o "
          "table.csv");
    case FileKind::Json:
      return StudioWindow::tr(
          "%1 is a JSON file of no known kind; Mien Studio opens animation tables (their \"format\" is \"mien "
          "animation "
          "table\"), sessions and the states that figures carry");
    case FileKind::Other:
      return StudioWindow::tr(
          "%1 is nothing that Mien Studio opens: .fap files, tables (.csv) of FAPs, action units or blendshapes, "
          "facial "
          "deformation tables (.csv), animation tables and sessions (.json), boundary curves (.vtp .mienz), scans "
          "(.ply .obj .stl "
          ".off), photographs (.png .jpg .tif), their meshes and landmarks (.csv)");
    default:
      return {};
  }
}

}  // namespace

StudioWindow::StudioWindow()
    : model_(new FaceModel(this)),
      player_(new AnimationPlayer(model_, this)),
      face_(new FaceView(model_)),
      curves_(new CurveView(model_)),
      views_(new ViewArea(model_, face_, curves_)),
      messages_(new MessageBar),
      laboratory_(new LaboratoryDocks(model_, player_, face_, curves_, this)),
      opener_(new FileOpener(model_, this)),
      keeper_(new SessionKeeper(model_, player_, this)) {
  setObjectName("studioWindow");
  setAcceptDrops(true);
  setCentralWidget(centre());
  addDocks();
  workspaces_ = new Workspaces(this);
  addMenus();
  menuBar()->setCornerWidget(workspaces_->bar());
  connect(model_, &FaceModel::failed, messages_, &MessageBar::showError);
  connect(model_, &FaceModel::remarked, messages_, &MessageBar::showNote);
  connect(model_, &FaceModel::recovered, messages_, &MessageBar::clearError);
  resize(QSize(studioWidth, studioHeight).boundedTo(screen()->availableSize() - QSize(0, titleBar)));
  WindowLayout::restore(*this);
  workspaces_->restore();
  keeper_->begin();
  connect(views_, &ViewArea::colorChosen, keeper_->history(), &History::act);
  connect(views_, &ViewArea::cameraMoved, keeper_->document(), &SessionDocument::followCameras);
  connect(workspaces_, &Workspaces::chosen, keeper_, &SessionKeeper::keep);
  connect(keeper_->history(), &History::travels, views_->coloring(), &FaceColoring::fitNext);
  const QString damage = keeper_->autosave() ? keeper_->autosave()->damage() : QString();
  if (!damage.isEmpty())
    messages_->showError(
        tr("What was kept when Mien Studio ended unexpectedly is damaged and cannot be shown; it was put aside."),
        damage);
}

StudioWindow::~StudioWindow() = default;

History& StudioWindow::history() {
  return *keeper_->history();
}

SessionDocument& StudioWindow::document() {
  return *keeper_->document();
}

QWidget* StudioWindow::centre() {
  auto* timeline = new TimelinePanel(model_, player_);
  laboratory_->addPlotButton(timeline);
  laboratory_->addSkinButton(views_->faceFrame());
  laboratory_->addScanSwitch(views_->faceFrame());
  connect(timeline, &TimelinePanel::openRequested, this, &StudioWindow::chooseAnimation);
  connect(timeline, &TimelinePanel::demonstrationRequested, this, &StudioWindow::playDemonstration);
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 6, 8, 8);
  column->setSpacing(6);
  column->addWidget(views_, 1);
  column->addWidget(timeline);
  QList<QWidget*> bars = {messages_};
  if (keeper_->autosave()) bars << new RecoveryBar(keeper_->autosave(), keeper_->document(), face_, box);
  new FloatingBars(views_, {face_, curves_}, bars, box);
  return box;
}

void StudioWindow::addDock(const QString& name, const QString& title, QWidget* panel) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  auto* scroll = new DockScroll(panel);
  scroll->setObjectName(name + "Scroll");
  dock->setWidget(scroll);
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                    QDockWidget::DockWidgetFloatable);
  addDockWidget(Qt::LeftDockWidgetArea, dock);
}

void StudioWindow::addDocks() {
  addDock("expressionDock", tr("Expression"), new ExpressionPanel(model_));
  addDock("fapDock", tr("Facial animation parameters"), new FAPPanel(model_));
  addDock("surfaceDock", tr("Surface"), new SurfacePanel(model_));
}

void StudioWindow::addMenus() {
  menuBar()->addMenu(new FileMenu(this, keeper_->document(), keeper_->recent()));
  menuBar()->addMenu(new EditMenu(keeper_->history(), model_, views_, this));
  addFaceMenu();
  menuBar()->addMenu(new ViewMenu(this, views_, workspaces_, messages_));
  menuBar()->addMenu(new HelpMenu(this));
}

void StudioWindow::addFaceMenu() {
  QMenu* face = menuBar()->addMenu(tr("F&ace"));
  face->setObjectName("faceMenu");
  QAction* play =
      face->addAction(tr("&Play or pause"), player_, [this] { player_->setPlaying(!player_->isPlaying()); });
  play->setShortcut(Qt::CTRL | Qt::Key_Space);
  QAction* reset = face->addAction(tr("&Neutral face"), this, &StudioWindow::resetAll);
  reset->setShortcut(Qt::CTRL | Qt::Key_0);
  reset->setObjectName("actionNeutral");
}

/// Sessions and copied commands name what is open, and are used from other folders.
bool StudioWindow::openFile(const QString& name) {
  const QFileInfo file(name);
  const QString fileName = file.absoluteFilePath();
  if (!file.exists() || file.isDir()) {
    messages_->showError(file.isDir()
                             ? tr("%1 is a folder; open a file in it.").arg(file.fileName())
                             : tr("There is no file %1; it was moved, or has another name.").arg(file.fileName()),
                         fileName);
    return false;
  }
  const size_t said = messages_->log().size();
  const bool good = openAs(fileKind(fileName), fileName);
  if (good) keeper_->recent()->add(fileName);
  if (good && messages_->log().size() == said) messages_->clearError();  // of what was tried before
  return good;
}

bool StudioWindow::openAs(FileKind kind, const QString& fileName) {
  const QString name = QFileInfo(fileName).fileName();
  if (kind == FileKind::AnimationTable) return openAnimationTable(fileName);
  if (kind == FileKind::Animation) return openAnimation(fileName);
  if (kind == FileKind::Session) return document().open(fileName);
  if (FileOpener::opens(kind)) return opener_->open(kind, fileName);
  if (kind != FileKind::DeformationTable) {
    messages_->showError(advice(kind).arg(name), fileName);
    return false;
  }
  if (!model_->openDeformationTable(fileName)) return false;
  messages_->showNote(tr("%1 bends the face now; the Deformation dock has its strength.").arg(name), fileName);
  return true;
}

bool StudioWindow::openAnimationTable(const QString& name) {
  const QString fileName = name.isEmpty() ? name : QFileInfo(name).absoluteFilePath();
  if (!model_->openAnimationTable(fileName)) return false;
  messages_->showNote(fileName.isEmpty() ? tr("The built-in animation table moves the face again.")
                                         : tr("%1 says now what each FAP moves.").arg(QFileInfo(fileName).fileName()),
                      fileName);
  return true;
}

bool StudioWindow::openAnimation(const QString& fileName) {
  const bool good = model_->openAnimation(fileName);
  if (good && !fileName.isEmpty()) setWindowFilePath(fileName);
  return good;
}

void StudioWindow::playStream(int descriptor) {
  delete stream_;
  stream_ = new LiveStream(model_, player_, descriptor, this);
  connect(stream_, &LiveStream::failed, messages_, &MessageBar::showError);
  connect(stream_, &LiveStream::ended, messages_, &MessageBar::showNote);
}

void StudioWindow::chooseAnimation() {
  const QString name =
      FileDialog::open(this, tr("Open"),
                       tr("All that can be opened (*.fap *.FAP *.csv *.CSV *.json *.JSON *.fdt *.FDT %1);;Facial "
                          "animation and capture (*.fap *.FAP *.csv *.CSV);;All files (*)")
                           .arg(FileOpener::endings()));
  if (!name.isEmpty()) openFile(name);
}

void StudioWindow::chooseAnimationTable() {
  const QString name =
      FileDialog::open(this, tr("Open animation table"), tr("Animation tables (*.json *.JSON);;All files (*)"));
  if (!name.isEmpty()) openAnimationTable(name);
}

void StudioWindow::playDemonstration() {
  if (openAnimation(bundledFile("animation/demo.fap"))) player_->play();
}

void StudioWindow::resetAll() {
  player_->pause();
  model_->change([](FaceState& state) {
    state.fapValues.clear();
    state.expressions.clear();
    state.visemes.clear();
    state.fapFile.clear();
    state.frame = 0.0;
    state.deformation = {};
  });
}

void StudioWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedFiles(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void StudioWindow::dropEvent(QDropEvent* event) {
  for (const QString& name : droppedFiles(event->mimeData()))
    if (openFile(name) && model_->state().fapFile == name.toStdString()) player_->play();
  event->acceptProposedAction();
}

void StudioWindow::closeEvent(QCloseEvent* event) {
  player_->pause();
  if (!document().mayClose()) return event->ignore();
  WindowLayout::save(*this);
  workspaces_->save();
  QMainWindow::closeEvent(event);
}

}  // namespace mien
