#include "ViewArea.h"

#include <QComboBox>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include "ColorKey.h"
#include "ColorScale.h"
#include "ColoringBar.h"
#include "CurveOverlay.h"
#include "CurveView.h"
#include "FaceColoring.h"
#include "FaceModel.h"
#include "ViewFrame.h"

namespace mien {

namespace {

constexpr int faceShare = 4, curveShare = 3;
constexpr int manyPixels = 1000;  // shares of a splitter, not pixels

}  // namespace

ViewArea::ViewArea(FaceModel* model, FaceView* face, CurveView* curves, QWidget* parent)
    : QWidget(parent), model_(model), face_(face), curves_(curves), faceFrame_(new ViewFrame(tr("Face"), face, this)) {
  addMeshChoice();
  addSideButtons();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(displayRow());
  column->addWidget(splitter(), 1);
  linkCameras(true);
}

QWidget* ViewArea::displayRow() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(2, 0, 0, 0);
  auto* coloring = new FaceColoring(model_, face_, this);
  auto* bar = new ColoringBar(coloring, row);
  faceFrame_->addBelow(coloring->key());
  auto* overlay = new CurveOverlay(model_, face_, this);
  connect(bar, &ColoringBar::curvesToggled, overlay, &CurveOverlay::setCurvesVisible);
  connect(bar, &ColoringBar::namesToggled, overlay, &CurveOverlay::setNamesVisible);
  layout->addWidget(bar);
  layout->addStretch();
  return row;
}

QWidget* ViewArea::splitter() {
  auto* splitter = new QSplitter(Qt::Horizontal, this);
  splitter->setObjectName("viewSplitter");
  splitter->setChildrenCollapsible(false);
  splitter->addWidget(faceFrame_);
  splitter->addWidget(curveFrame());
  splitter->setStretchFactor(0, faceShare);
  splitter->setStretchFactor(1, curveShare);
  splitter->setSizes({faceShare * manyPixels, curveShare * manyPixels});
  return splitter;
}

void ViewArea::addMeshChoice() {
  auto* mesh = new QComboBox(faceFrame_);
  mesh->setObjectName("faceMesh");
  mesh->addItems({tr("Shaded"), tr("Wireframe"), tr("Shaded with mesh"), tr("Points")});
  mesh->setToolTip(tr("The surface lit, the lines of its mesh, both, or its points"));
  connect(mesh, QOverload<int>::of(&QComboBox::currentIndexChanged), face_,
          [this](int index) { face_->setMesh(static_cast<FaceView::Mesh>(index)); });
  faceFrame_->addControl(mesh);
}

void ViewArea::addSideButtons() {
  const auto add = [&](const QString& name, const QString& text, const QString& tip, RenderView::Side side) {
    connect(faceFrame_->addButton(name, text, tip), &QToolButton::clicked, this, [this, side] { look(side); });
  };
  faceFrame_->addGap();
  add("lookFront", tr("Front"), tr("Look from the front"), RenderView::Side::Front);
  add("lookFortyFive", tr("45\u00b0"), tr("Look from 45 degrees at the subject's left"), RenderView::Side::FortyFive);
  add("lookSide", tr("Side"), tr("Look at the subject's left side"), RenderView::Side::Profile);
  connect(faceFrame_->addButton("lookReset", tr("Reset"), tr("The whole face again (double click in a view)")),
          &QToolButton::clicked, this, &ViewArea::showWhole);
}

QWidget* ViewArea::curveFrame() {
  auto* frame = new ViewFrame(tr("Curves"), curves_, this);
  frame->addBelow(new ColorScale(model_, this));
  connect(frame->addToggle("curvePoints", tr("Points"), tr("The points of the curves"), true), &QToolButton::toggled,
          curves_, &CurveView::setPointsVisible);
  connect(frame->addToggle("curveNeutral", tr("Neutral"), tr("The curves of the neutral face, thin and pale"), true),
          &QToolButton::toggled, curves_, &CurveView::setNeutralVisible);
  connect(frame->addToggle("curveFrontOnly", tr("Front only"), tr("Whether the face hides the curves behind it"), true),
          &QToolButton::toggled, curves_, &CurveView::setBackHidden);
  connect(frame->addToggle("curveLink", tr("Link"), tr("Turn and zoom together with the face"), true),
          &QToolButton::toggled, this, &ViewArea::linkCameras);
  return frame;
}

void ViewArea::linkCameras(bool linked) {
  linked ? curves_->link(face_) : curves_->unlink();
}

void ViewArea::look(RenderView::Side side) {
  face_->look(side);
  if (!curves_->isLinked()) curves_->look(side);
}

void ViewArea::showWhole() {
  face_->fit();
  if (!curves_->isLinked()) curves_->fit();
}

void ViewArea::useTheme() {
  face_->useTheme();
  curves_->useTheme();
}

}  // namespace mien
