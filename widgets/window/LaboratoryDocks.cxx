#include "LaboratoryDocks.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QMainWindow>
#include <QToolButton>
#include <algorithm>

#include "AnimationPlayer.h"
#include "ContinuityPanel.h"
#include "CurvePanel.h"
#include "DeformationPanel.h"
#include "DockScroll.h"
#include "FAPPlotPanel.h"
#include "FaceView.h"
#include "ScanPanel.h"
#include "SessionPart.h"
#include "SmoothingPanel.h"
#include "SpectrumPanel.h"
#include "TexturePanel.h"
#include "TimelinePanel.h"
#include "VectorPanel.h"
#include "ViewFrame.h"

namespace mien {

namespace {

/// How high a dock is when it is opened.
struct Height {
  int least;     ///< pixels
  double share;  ///< of a higher window

  int in(const QMainWindow& window) const { return std::max(least, static_cast<int>(share * window.height())); }
};

constexpr Height tableHeight = {290, 0.35};    // nine rows of a table and half of a window of 800 left for the face
constexpr Height pictureHeight = {380, 0.40};  // of a dock that shows a face itself

}  // namespace

LaboratoryDocks::LaboratoryDocks(FaceModel* model, AnimationPlayer* player, FaceView* view, CurveView* curves,
                                 QMainWindow* window)
    : QObject(window), view_(view), window_(window) {
  window->setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  plot_ = add("plotDock", tr("FAPs over time"), new FAPPlotPanel(model, player));
  giveHeight(plot_, false);
  auto* vectorPanel = new VectorPanel(model, view);
  giveHeight(add("vectorsDock", tr("Motion vectors"), vectorPanel), true);
  connect(player, &AnimationPlayer::playingChanged, vectorPanel, [vectorPanel](bool playing) {
    if (playing) vectorPanel->fit();
  });
  giveHeight(add("spectrumDock", tr("Spectrum"), new SpectrumPanel(model, view)), false);
  giveHeight(add("smoothingDock", tr("Smoothing"), new SmoothingPanel(model)), false);
  giveHeight(add("continuityDock", tr("Continuity"), new ContinuityPanel(model, view)), false);
  giveHeight(add("deformationDock", tr("Deformation"), new DeformationPanel(model, view)), false);
  giveHeight(add("curvesDock", tr("Curves and scan"), new CurvePanel(model, view, curves)), false);
  giveHeight(add("textureDock", tr("Texture"), new TexturePanel(model, view)), true);
}

/// A dock that shows a picture itself is higher than a table when it is opened.
void LaboratoryDocks::giveHeight(QDockWidget* dock, bool hasPicture) {
  connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock, hasPicture](bool shown) {
    const int height = (hasPicture ? pictureHeight : tableHeight).in(*window_);
    if (shown && dock->height() < height) window_->resizeDocks({dock}, {height}, Qt::Vertical);
  });
}

QDockWidget* LaboratoryDocks::add(const QString& name, const QString& title, QWidget* panel) {
  auto* dock = new QDockWidget(title, window_);
  dock->setObjectName(name);
  auto* scroll = new DockScroll(panel);
  scroll->setObjectName(name + "Scroll");
  dock->setWidget(scroll);
  dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                    QDockWidget::DockWidgetFloatable);
  window_->addDockWidget(Qt::BottomDockWidgetArea, dock);
  if (last_) window_->tabifyDockWidget(last_, dock);
  last_ = dock;
  window_->resizeDocks({dock}, {tableHeight.least}, Qt::Vertical);
  dock->toggleViewAction()->setObjectName(name + "Action");
  connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
    if (shown) dock->raise();
  });
  dock->hide();
  return dock;
}

void LaboratoryDocks::addPlotButton(TimelinePanel* timeline) {
  auto* button = new QToolButton(timeline);
  button->setObjectName("timelinePlot");
  button->setText(tr("Plot"));
  button->setToolTip(tr("The FAPs of the animation over time, below"));
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setProperty(notInSession, true);  // the layout says whether the plot is open
  connect(button, &QToolButton::clicked, plot_, [this](bool on) {
    plot_->setVisible(on);
    if (on) plot_->raise();
  });
  connect(plot_->toggleViewAction(), &QAction::toggled, button, &QToolButton::setChecked);
  timeline->addButton(button);
}

/// Whatever workspace is open, a scan over the face can be seen to be one, and taken away.
void LaboratoryDocks::addScanSwitch(ViewFrame* frame) {
  QToolButton* shown =
      frame->addLastingButton("faceScan", tr("Scan"), tr("The scan over the face; File > Close scan ends it"));
  shown->setCheckable(true);
  shown->setChecked(true);
  shown->setProperty(notInSession, true);  // the dock's own tick is
  shown->hide();
  auto* panel = window_->findChild<ScanPanel*>();
  auto* tick = panel->findChild<QCheckBox*>("scanVisible");
  connect(panel, &ScanPanel::scanChanged, shown, [panel, shown] { shown->setVisible(panel->hasScan()); });
  connect(shown, &QToolButton::toggled, tick, &QCheckBox::setChecked);
  connect(tick, &QCheckBox::toggled, shown, &QToolButton::setChecked);
  const auto follow = [tick, shown, told = shown->toolTip()] {
    shown->setEnabled(tick->isEnabled());
    shown->setToolTip(tick->isEnabled() ? told : tick->toolTip());
  };
  connect(view_, &FaceView::overlayChanged, shown, follow);
  connect(panel, &ScanPanel::scanChanged, shown, follow);
}

void LaboratoryDocks::addSkinButton(ViewFrame* frame) {
  QToolButton* skin = frame->addButton("faceSkin", tr("Skin"),
                                       tr("The plain skin again, without the numbers that a dock shows on the face"));
  skin->setEnabled(false);
  connect(skin, &QToolButton::clicked, view_, [this] { view_->showOverlay(nullptr, true); });
  connect(view_, &FaceView::overlayChanged, skin,
          [skin](const QObject* overlay) { skin->setEnabled(overlay != nullptr); });
}

}  // namespace mien
