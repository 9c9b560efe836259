#include "LaboratoryDocks.h"

#include "ContinuityPanel.h"
#include "DeformationPanel.h"
#include "FaceView.h"
#include "SmoothingPanel.h"
#include "SpectrumPanel.h"
#include "ViewFrame.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QToolButton>

namespace mien {

namespace {

constexpr int startHeight = 290;  // pixels: nine rows of a table, and half of a window of 800 left for the face

}  // namespace

LaboratoryDocks::LaboratoryDocks(FaceModel* model, FaceView* view, QMainWindow* window)
    : QObject(window), view_(view), window_(window) {
  window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  add("spectrumDock", tr("Spectrum"), new SpectrumPanel(model, view));
  add("smoothingDock", tr("Smoothing"), new SmoothingPanel(model));
  add("continuityDock", tr("Continuity"), new ContinuityPanel(model, view));
  add("deformationDock", tr("Deformation"), new DeformationPanel(model, view));
}

void LaboratoryDocks::add(const QString& name, const QString& title, QWidget* panel) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(name);
  dock->setWidget(panel);
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
  window_->addDockWidget(Qt::BottomDockWidgetArea, dock);
  if (last_) window_->tabifyDockWidget(last_, dock);
  last_ = dock;
  window_->resizeDocks({dock}, {startHeight}, Qt::Vertical);
  dock->toggleViewAction()->setObjectName(name + "Action");
  connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
    if (shown) dock->raise();
  });
  dock->hide();
}

void LaboratoryDocks::addSkinButton(ViewFrame* frame) {
  QToolButton* skin = frame->addButton("faceSkin", tr("Skin"), tr("The plain skin again, without the numbers that a dock shows on the face"));
  skin->setEnabled(false);
  connect(skin, &QToolButton::clicked, view_, [this] { view_->showOverlay(nullptr, true); });
  connect(view_, &FaceView::overlayChanged, skin, [skin](const QObject* overlay) { skin->setEnabled(overlay != nullptr); });
}

}  // namespace mien
