#include "ViewArea.h"

#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <limits>

#include "ColorKey.h"
#include "ColorScale.h"
#include "ColoringBar.h"
#include "Comparison.h"
#include "ComparisonBar.h"
#include "ComparisonSummary.h"
#include "CurveKeyBar.h"
#include "CurveOverlay.h"
#include "CurveView.h"
#include "DifferenceArrows.h"
#include "Exporter.h"
#include "FaceColoring.h"
#include "FaceModel.h"
#include "FaceOutline.h"
#include "FaceStateText.h"
#include "PointNumbers.h"
#include "ViewExport.h"
#include "ViewFrame.h"

namespace mien {

namespace {

constexpr int manyPixels = 1000;       // a share of a splitter, not pixels
constexpr int roomForThree = 1300;     // pixels
constexpr int summaryMargin = 12;      // pixels
constexpr int aroundMesh = 12;         // pixels between the edges of a view and a mesh that is compared
constexpr double longestArrow = 20.0;  // mm to a nearest point: beyond, the other has no counterpart, as a neck
constexpr double arrowFactors[] = {0.0, 1.0, 2.0, 5.0, 10.0};

std::string motionOf(const FaceModel& model) {
  const std::string motion = model.motionText();
  return motion.empty() ? "neutral" : motion;
}

}  // namespace

ViewArea::ViewArea(FaceModel* model, FaceView* face, CurveView* curves, QWidget* parent)
    : QWidget(parent),
      model_(model),
      face_(face),
      curves_(curves),
      comparison_(new Comparison(model, this)),
      coloring_(new FaceColoring(model, face, comparison_, this)),
      faceFrame_(new ViewFrame(tr("Face"), face, this)),
      curveFrame_(new ViewFrame(tr("Curve view"), curves_, this)),
      mesh_(new QComboBox(faceFrame_)),
      splitter_(new QSplitter(Qt::Horizontal, this)) {
  setObjectName("viewArea");
  overlays_.push_back(new CurveOverlay(model_, face_, this));
  arrows_.push_back(new DifferenceArrows(face_, this));
  addMeshChoice();
  addSideButtons();
  addCurveFrame();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(displayRow());
  column->addWidget(splitter(), 1);
  linkCameras(true);
  addExporters();
  for (const RenderView* view : std::initializer_list<RenderView*>{face_, curves_})
    connect(view, &RenderView::cameraMoved, this, &ViewArea::cameraMoved);
  connect(comparison_, &Comparison::changed, this, &ViewArea::followComparison);
  connect(comparison_, &Comparison::measured, this, &ViewArea::showDifference);
}

QWidget* ViewArea::displayRow() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(2, 0, 0, 0);
  layout->setSpacing(6);
  auto* bar = new ColoringBar(coloring_, row);
  faceKey_ = coloring_->key();
  faceFrame_->addFoot(faceKey_);
  connect(bar, &ColoringBar::colorChosen, this, &ViewArea::colorChosen);
  connect(bar, &ColoringBar::curvesToggled, this, [this](bool on) {
    curvesOn_ = on;
    showCurves();
  });
  connect(bar, &ColoringBar::namesToggled, this, [this](bool on) {
    namesOn_ = on;
    showCurves();
  });
  layout->addWidget(bar, 1);
  layout->addWidget(new ComparisonBar(comparison_, row));
  return row;
}

QWidget* ViewArea::splitter() {
  splitter_->setObjectName("viewSplitter");
  splitter_->setChildrenCollapsible(false);
  splitter_->addWidget(faceFrame_);
  splitter_->addWidget(curveFrame_);
  shareOut();
  return splitter_;
}

/// Equal views, which show the face equally large.
void ViewArea::shareOut() {
  QList<int> shares;
  for (int i = 0; i < splitter_->count(); ++i) {
    splitter_->setStretchFactor(i, 1);
    shares << manyPixels;
  }
  splitter_->setSizes(shares);
}

void ViewArea::addMeshChoice() {
  mesh_->setObjectName("faceMesh");
  mesh_->addItems({tr("Shaded"), tr("Wireframe"), tr("Both"), tr("Points")});
  mesh_->setAccessibleName(tr("Drawing style"));
  mesh_->setToolTip(tr("The surface lit, the lines of its mesh, both, or its points"));
  connect(mesh_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    face_->setMesh(static_cast<FaceView::Mesh>(index));
    if (other_) other_->setMesh(face_->mesh());
  });
  faceFrame_->addControl(mesh_);
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

void ViewArea::addCurveFrame() {
  auto* key = new CurveKeyBar(curves_, this);
  curveKey_ = key->scale();
  curveFoot_ = key;
  curveFrame_->addFoot(key);
  const auto add = [&](const QString& name, const QString& text, const QString& tip) {
    return curveFrame_->addToggle(name, text, tip, true);
  };
  connect(add("curvePoints", tr("Points"), tr("The points of the curves, smaller where they are close together")),
          &QToolButton::toggled, curves_, &CurveView::setPointsVisible);
  connect(add("curveNeutral", tr("Neutral"), tr("The curves of the neutral face, thin and pale")),
          &QToolButton::toggled, curves_, &CurveView::setNeutralVisible);
  connect(add("curveFrontOnly", tr("Front only"),
              tr("Whether the face hides the curves behind it, those seen through its open mouth too")),
          &QToolButton::toggled, curves_, &CurveView::setBackHidden);
  connect(add("curveLink", tr("Link"), tr("Turn and zoom together with the face")), &QToolButton::toggled, this,
          &ViewArea::linkCameras);
}

/// Made when it is first needed: most never compare, and a view takes time to begin.
void ViewArea::addOther() {
  other_ = new FaceView(comparison_->other());
  other_->setObjectName("otherFaceView");
  other_->setMesh(face_->mesh());
  connect(other_, &RenderView::cameraMoved, this, &ViewArea::cameraMoved);
  otherFrame_ = new ViewFrame(QString(), other_, this);
  coloring_->setOther(other_);
  otherFrame_->addFoot(coloring_->key());
  for (ViewFrame* frame : {faceFrame_, otherFrame_}) addSummary(frame);
  addOtherButtons();
  overlays_.push_back(new CurveOverlay(comparison_->other(), other_, this));
  arrows_.push_back(new DifferenceArrows(other_, this));
  keepFeet();
  splitter_->insertWidget(1, otherFrame_);
  shareOut();
  other_->link(face_, RenderView::Zoom::ToScale);
}

/// Below both, so that both are of one height.
void ViewArea::addSummary(ViewFrame* frame) {
  auto* summary = new ComparisonSummary(frame);
  summary->setObjectName(frame == faceFrame_ ? "compareSummaryA" : "compareSummaryB");
  summary->setContentsMargins(summaryMargin, 0, summaryMargin, summaryMargin / 2);
  summary->setToolTip(
      tr("How far A and B lie apart, weighted with area: from point to point where they have the same mesh, else from "
         "each point to the nearest of the other surface; of a mesh or scan only the share of the points that lies "
         "opposite "
         "the other counts, not a neck, if there is such a share"));
  frame->addBelow(summary);
  if (!summaries_.empty()) summary->setTwin(summaries_.front());
  summaries_.push_back(summary);
}

void ViewArea::addOtherButtons() {
  auto* arrows = new QComboBox(otherFrame_);
  arrows->setObjectName("compareArrows");
  for (double factor : arrowFactors)
    arrows->addItem(factor > 0.0 ? tr("Arrows \u00d7 %1").arg(factor) : tr("No arrows"), factor);
  arrows->setToolTip(
      tr("The difference as arrows: on A from its points to those of B, on B from its points to those of A; of a mesh "
         "or scan to the nearest point. True length, or 2 to 10 times as long"));
  connect(arrows, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, arrows] {
    for (DifferenceArrows* one : arrows_) one->setFactor(arrows->currentData().toDouble());
    showDifference();  // which tells the factor
  });
  otherFrame_->addControl(arrows);
  otherFrame_->addGap();
  QToolButton* link = otherFrame_->addToggle("compareLink", tr("Link"), tr("Turn and zoom together with A"), true);
  connect(link, &QToolButton::toggled, this,
          [this](bool on) { on ? other_->link(face_, RenderView::Zoom::ToScale) : other_->unlink(); });
  swap_ = otherFrame_->addButton("compareSwap", tr("Swap"), tr("A becomes B, and B becomes A"));
  connect(swap_, &QToolButton::clicked, comparison_, &Comparison::swap);
  connect(otherFrame_->addLastingButton("compareClear", tr("Close"), tr("Ends the comparison")), &QToolButton::clicked,
          comparison_, &Comparison::clear);
}

void ViewArea::followComparison() {
  const bool compares = comparison_->kind() != Comparison::Kind::None;
  if (compares && !other_) addOther();
  if (!compares) faceFrame_->setTitle(tr("Face"));
  if (compares) swap_->setEnabled(comparison_->canSwap());
  showCurves();
  showDifference();
  arrange();
}

/// Crown and ears of a head stay within the views; its neck and its shoulders, beside which the face would be small,
/// may leave them. A mesh of which nothing lies opposite the face is whole, as it may lie anywhere.
void ViewArea::holdMesh() {
  if (!other_) return;
  vtkPolyData* mesh = comparison_->mesh();
  const bool isAway = mesh && comparison_->surface(Comparison::Side::B) && !comparison_->leavesOut();
  const SeenPoints held = isAway ? furthestPoints(mesh) : mesh ? furthestOfHead(mesh, *model_) : SeenPoints();
  if (held == held_) return;
  held_ = held;
  other_->setCompany(held, aroundMesh);
  if (!face_->isMoved()) face_->fit();
  if (!other_->isLinked() && !other_->isMoved()) other_->fit();
}

/// A mesh has no curves.
void ViewArea::showCurves() {
  for (CurveOverlay* overlay : overlays_) {
    const bool hasCurves = overlay == overlays_.front() || !comparison_->mesh();
    overlay->setCurvesVisible(curvesOn_ && hasCurves);
    overlay->setNamesVisible(namesOn_ && hasCurves);
  }
}

/// With what the arrows on that side mean: a picture of them says little without.
QString ViewArea::summaryOf(Comparison::Side side) const {
  const QString summary = comparison_->summary(side);
  const double factor = arrows_.empty() ? 0.0 : arrows_.front()->factor();
  const int colon = summary.indexOf(": ");
  if (factor == 0.0 || colon < 0) return summary;
  const QString lead = side == Comparison::Side::A ? tr("arrows to B \u00d7 %1") : tr("arrows to A \u00d7 %1");
  return summary.left(colon) + ", " + lead.arg(factor) + summary.mid(colon);
}

void ViewArea::showDifference() {
  const bool compares = comparison_->kind() != Comparison::Kind::None;
  if (compares) faceFrame_->setTitle(tr("A: %1").arg(comparison_->nameOfA()));
  if (compares && otherFrame_) otherFrame_->setTitle(tr("B: %1").arg(comparison_->name()));
  const Comparison::Side sides[] = {Comparison::Side::A, Comparison::Side::B};
  for (size_t i = 0; i < summaries_.size(); ++i) {
    summaries_[i]->setSummary(summaryOf(sides[i]));
    summaries_[i]->setVisible(compares);
  }
  const double longest = comparison_->corresponds() ? std::numeric_limits<double>::infinity() : longestArrow;
  for (size_t i = 0; i < arrows_.size(); ++i) arrows_[i]->show(comparison_->drawn(sides[i]), "DistanceVector", longest);
  holdMesh();
}

void ViewArea::addExporters() {
  faceExporter_ = new Exporter(
      model_, [this](const ExportOptions& options) { return faceDrawing(options); }, [this] { return faceNumbers(); },
      this);
  curveExporter_ = new Exporter(
      model_,
      [this](const ExportOptions& options) {
        return viewDrawing({{curves_}}, curveKey_, "Boundary curves, " + motionOf(*model_), {}, options);
      },
      [this] { return pointNumbers(vtkPolyData::SafeDownCast(model_->pipeline().curves()->GetOutputDataObject(0))); },
      this);
}

/// A comparison is one figure: A and B beside each other over the scale that they share.
ExportDrawing ViewArea::faceDrawing(const ExportOptions& options) const {
  if (comparison_->kind() == Comparison::Kind::None)
    return viewDrawing({{face_}}, faceKey_, "Face, " + motionOf(*model_), {}, options);
  const std::string a = "A: " + comparison_->nameOfA().toStdString(), b = "B: " + comparison_->name().toStdString();
  QString note = summaryOf(Comparison::Side::A);
  if (!note.isEmpty() && !comparison_->corresponds()) note += "; " + summaryOf(Comparison::Side::B);
  ExportDrawing drawing = viewDrawing({{face_, a}, {other_, b}}, faceKey_, a + ", " + b, note.toStdString(), options);
  if (!comparison_->mesh()) drawing.description = "\nB:\n" + writeFaceState(comparison_->other()->state());
  return drawing;
}

std::string ViewArea::faceNumbers() const {
  vtkPolyData* compared = comparison_->surface(Comparison::Side::A);
  return pointNumbers(compared ? compared
                               : vtkPolyData::SafeDownCast(model_->pipeline().surface()->GetOutputDataObject(0)));
}

void ViewArea::arrange() {
  const bool compares = comparison_->kind() != Comparison::Kind::None;
  if (otherFrame_) otherFrame_->setVisible(compares);
  curveFrame_->setVisible(!compares || width() >= roomForThree);
}

void ViewArea::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
  keepFeet();
}

/// Keys have one height, and views room for them whether they are shown or not: they are of one scale, whatever is
/// chosen as colour.
void ViewArea::keepFeet() {
  const int foot = curveFoot_->sizeHint().height();
  for (RenderView* view : std::initializer_list<RenderView*>{face_, other_, curves_})
    if (view) view->setFoot(foot);
  for (QWidget* key : coloring_->keys()) key->setFixedHeight(foot);
}

void ViewArea::linkCameras(bool linked) {
  linked ? curves_->link(face_) : curves_->unlink();
}

void ViewArea::look(RenderView::Side side) {
  face_->look(side);
  if (!curves_->isLinked()) curves_->look(side);
  if (other_ && !other_->isLinked()) other_->look(side);
}

void ViewArea::showWhole() {
  face_->fit();
  if (!curves_->isLinked()) curves_->fit();
  if (other_ && !other_->isLinked()) other_->fit();
}

void ViewArea::useTheme() {
  face_->useTheme();
  curves_->useTheme();
  if (other_) other_->useTheme();
}

}  // namespace mien
