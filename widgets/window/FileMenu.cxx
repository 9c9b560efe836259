#include "FileMenu.h"

#include "FaceModel.h"
#include "FileDialog.h"
#include "RecentMenu.h"
#include "ScanPanel.h"
#include "SessionDocument.h"
#include "SessionFile.h"
#include "StudioWindow.h"

namespace mien {

FileMenu::FileMenu(StudioWindow* window, SessionDocument* document, RecentFiles* recent)
    : QMenu(tr("&File"), window), window_(window), document_(document) {
  setObjectName("fileMenu");
  addSession();
  addMenu(new RecentMenu(window, recent));
  addSeparator();
  addAnimation();
  addClosing();
  addSeparator();
  addTables();
  addSeparator();
  addAction(tr("&Quit"), window_, &QWidget::close)->setShortcut(QKeySequence::Quit);
}

void FileMenu::addSession() {
  QAction* fresh = addAction(tr("&New session"), document_, &SessionDocument::startNew);
  fresh->setObjectName("actionNewSession");
  fresh->setShortcut(QKeySequence::New);
  QAction* open = addAction(tr("Open s&ession..."), this, &FileMenu::chooseSession);
  open->setObjectName("actionOpenSession");
  open->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_O);
  QAction* save = addAction(tr("&Save session"), document_, QOverload<>::of(&SessionDocument::save));
  save->setObjectName("actionSaveSession");
  save->setShortcut(QKeySequence::Save);
  QAction* saveAs = addAction(tr("Save session &as..."), document_, &SessionDocument::saveAs);
  saveAs->setObjectName("actionSaveSessionAs");
  saveAs->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_S);
}

void FileMenu::addAnimation() {
  addAction(tr("&Open..."), window_, &StudioWindow::chooseAnimation)->setShortcut(QKeySequence::Open);
  addAction(tr("Play the &demonstration"), window_, &StudioWindow::playDemonstration);
  QAction* close = addAction(tr("&Close animation"), &window_->model(), &FaceModel::closeAnimation);
  close->setShortcut(QKeySequence::Close);
  close->setEnabled(false);
  FaceModel* model = &window_->model();
  connect(model, &FaceModel::stateChanged, this,
          [model, close] { close->setEnabled(!model->state().fapFile.empty()); });
}

/// The face and the scan that were opened go as they came.
void FileMenu::addClosing() {
  auto* panel = window_->findChild<ScanPanel*>();
  QAction* scan = addAction(tr("C&lose scan"), panel, &ScanPanel::close);
  scan->setObjectName("actionCloseScan");
  scan->setEnabled(false);
  connect(panel, &ScanPanel::scanChanged, scan, [panel, scan] { scan->setEnabled(panel->isOpen()); });
  FaceModel* model = &window_->model();
  QAction* generic = addAction(tr("Back to the &generic face"), model, [model] { model->openCurves(QString()); });
  generic->setObjectName("actionGenericFace");
  generic->setEnabled(false);
  connect(model, &FaceModel::stateChanged, this,
          [model, generic] { generic->setEnabled(!model->state().curvesFile.empty()); });
}

void FileMenu::addTables() {
  addAction(tr("Open animation &table..."), window_, &StudioWindow::chooseAnimationTable)
      ->setObjectName("actionOpenTable");
  QAction* builtIn =
      addAction(tr("&Built-in animation table"), window_, [this] { window_->openAnimationTable(QString()); });
  builtIn->setObjectName("actionBuiltInTable");
  builtIn->setEnabled(false);
  FaceModel* model = &window_->model();
  connect(model, &FaceModel::stateChanged, this,
          [model, builtIn] { builtIn->setEnabled(!model->state().animationTable.empty()); });
}

void FileMenu::chooseSession() {
  if (!document_->mayClose()) return;
  const QString name = FileDialog::open(window_, tr("Open session"),
                                        tr("Sessions (*%1 *.json);;All files (*)").arg(SessionFile::ending));
  if (!name.isEmpty()) document_->open(name);
}

}  // namespace mien
