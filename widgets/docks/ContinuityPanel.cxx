#include "ContinuityPanel.h"

#include <vtkGeometryFilter.h>
#include <vtkPDEFaceFilter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkStructuredGrid.h>
#include <vtkTable.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ContinuityTable.h"
#include "CsvTable.h"
#include "ExportButton.h"
#include "FaceCaption.h"
#include "FaceModel.h"
#include "FaceScheme.h"
#include "FaceView.h"
#include "FigureView.h"
#include "FlipBox.h"
#include "LiveUpdate.h"
#include "OverflowRow.h"
#include "RoundedUp.h"
#include "SeamMeasureKind.h"
#include "SurfaceParameters.h"
#include "WholeRows.h"

namespace mien {

namespace {

constexpr int fineRows = 218, fineColumns = 160;  // every curve is a row, and a stripe runs over several cells
constexpr int leastProfile = 150;                 // pixels beside the table
constexpr double meanRange = 0.05;                // 1/mm: a radius of 20 mm
constexpr double gaussianRange = 0.002;           // 1/mm^2
constexpr double pointExtent = 60.0;              // mm, around one point of a seam
constexpr double seamMargin = 1.2;
constexpr double steepest = 0.8, perMillimetre = 0.008;  // how far the camera rises with a seam's height

double largestOf(const SeamProfile& profile) {
  double largest = 0.0;
  for (double value : profile.value)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

}  // namespace

ContinuityPanel::ContinuityPanel(FaceModel* model, FaceView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      view_(view),
      table_(new ContinuityTable(this)),
      figure_(new FigureView("continuityFigure", FigureView::Marker::Line, this)),
      overlay_(new FaceOverlay(view, tr("Continuity"), this)),
      flight_(new CameraFlight(view, this)),
      rows_(new QComboBox(this)),
      part_(new QComboBox(this)),
      measure_(new QComboBox(this)),
      onFace_(new QComboBox(this)),
      schemes_(faceSchemes().size()),
      faults_(faceSchemes().size()) {
  setObjectName("continuityPanel");
  errors_.observe(fine_);
  describeControls();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(4);
  column->addWidget(controls());
  auto* both = new FlipBox(new WholeRows(table_, ContinuityTable::leastLine, ContinuityTable::mostLine, this), figure_,
                           1, 1, this);
  both->showAllOfFirst(leastProfile);
  figure_->setMinimumWidth(leastProfile);
  column->addWidget(both, 1);
  connectControls();
  new LiveUpdate(
      model, this, [this] { refresh(); }, [this] { return overlay_->isShown(); });
}

ContinuityPanel::~ContinuityPanel() = default;

void ContinuityPanel::describeControls() {
  rows_->setObjectName("continuityRows");
  rows_->setAccessibleName(tr("Rows"));
  rows_->addItems({tr("Seams"), tr("Schemes")});
  rows_->setToolTip(tr("A row for each of the eight seams, or for each scheme over all seams"));
  part_->setObjectName("continuityPart");
  part_->setAccessibleName(tr("Part of the seams"));
  part_->addItems({tr("Whole"), tr("Front only")});
  part_->setToolTip(tr("All of a seam, or its part with z > 50 mm"));
  measure_->setObjectName("continuityMeasure");
  measure_->setAccessibleName(tr("Profile"));
  for (const SeamMeasureKind& kind : SeamMeasureKind::all()) {
    measure_->addItem(QString::fromStdString(titleWithUnit(kind.axis)));
    measure_->setItemData(measure_->count() - 1, QString::fromStdString(kind.toolTip), Qt::ToolTipRole);
  }
  measure_->setToolTip(tr("What the profile shows along v, and the seams' colours on the face"));
  onFace_->setObjectName("continuityFace");
  onFace_->setAccessibleName(tr("On the face"));
  onFace_->addItems({tr("Skin"), tr("Seams"), tr("Mean curvature"), tr("Gaussian curvature"), tr("Zebra stripes")});
  onFace_->setToolTip(
      tr("What the face shows: the measure along its seams, curvatures H (1/mm) or K (1/mm\u00b2), or stripes of equal "
         "slope, which break where the surface has a crease and have corners where its curvature jumps"));
  table_->setToolTip(tr("Choose a seam to fly there; double click a scheme to use it"));
  figure_->setToolTip(tr("Click at a place of the seam to fly there; v = 180\u00b0 is the nose bridge"));
}

QWidget* ContinuityPanel::controls() {
  auto* row = new OverflowRow("continuityControls", this);
  row->addWidget(rows_);
  row->addWidget(part_, 3);
  row->addLabelled(tr("Profile"), measure_, 1);
  row->addLabelled(tr("On the face"), onFace_, 2);
  row->addStretch();
  row->addWidget(new ExportButton(
                     "continuityExport", model_,
                     [this](const ExportOptions& options) { return ExportDrawing(profileFigure(), options); },
                     [this] { return numbers(); }, row),
                 4);
  return row;
}

void ContinuityPanel::connectControls() {
  const auto chosen = QOverload<int>::of(&QComboBox::currentIndexChanged);
  connect(rows_, chosen, this, [this] { refresh(); });
  connect(part_, chosen, this, [this] { fillTable(); });
  connect(measure_, chosen, this, [this] {
    showProfile();
    if (onFace_->currentIndex() == Seamlines) paintFace();
  });
  connect(onFace_, chosen, this, [this] { paintFace(); });
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ContinuityPanel::chooseRow);
  connect(table_, &QTableWidget::cellClicked, this, &ContinuityPanel::flyToRow);  // back to the row chosen before
  connect(table_, &QTableWidget::cellActivated, this, &ContinuityPanel::useScheme);
  connect(figure_, &FigureView::picked, this, &ContinuityPanel::flyTo);
  connect(figure_, &FigureView::stepped, this, [this](int steps) { flyTo(figure_->marked().value_or(180.0) + steps); });
  connect(overlay_, &FaceOverlay::shownChanged, this, [this](bool shown) {
    if (!shown) onFace_->setCurrentIndex(Skin);
  });
}

bool ContinuityPanel::comparesSchemes() const {
  return rows_->currentIndex() == Schemes;
}

void ContinuityPanel::refresh() {
  measure();
  fillTable();
  showProfile();
  if (onFace_->currentIndex() != Skin) paintFace();
}

/// Only what is seen: all schemes take six times as long.
void ContinuityPanel::measure() {
  vtkNew<vtkPolyData> curves;
  curves->ShallowCopy(model_->pipeline().curves()->GetOutputDataObject(0));
  FaceSurfaceOptions options = model_->state().surface;
  for (size_t i = 0; i < schemes_.size(); ++i) {
    const bool isShown = faceSchemes()[i].name == model_->state().surface.scheme;
    if (isShown) shown_ = i;
    if (!isShown && !comparesSchemes()) continue;
    options.scheme = faceSchemes()[i].name;
    faults_[i] = QString::fromStdString(schemes_[i].measure(curves, options));
  }
}

void ContinuityPanel::fillTable() {
  const bool frontal = part_->currentIndex() == 1;
  QStringList names;
  if (comparesSchemes()) {
    for (const FaceScheme& scheme : faceSchemes()) names << QString::fromStdString(scheme.name);
    table_->setRowNames(tr("Scheme"), names);
    const int all = static_cast<int>(shown().seamNames().size());
    for (int row = 0; row < names.size(); ++row)
      schemes_[row].isValid() ? table_->setSummary(row, schemes_[row].summary(), all, frontal)
                              : table_->setFault(row, faults_[row]);
    return;
  }
  for (const std::string& name : shown().seamNames()) names << QString::fromStdString(name);
  names << tr("all");
  table_->setRowNames(tr("Seam"), names);
  for (int row = 0; row < names.size(); ++row)
    shown().isValid() ? table_->setSummary(row, shown().summary(), row, frontal)
                      : table_->setFault(row, faults_[shown_]);
  if (table_->currentRow() < 0) markSeam();
}

/// The row of the profile, without a flight to it.
void ContinuityPanel::markSeam() {
  const QSignalBlocker quiet(table_);
  table_->selectRow(seam_);
}

Figure ContinuityPanel::profileFigure() const {
  const SeamMeasureKind& kind = SeamMeasureKind::all()[measure_->currentIndex()];
  std::vector<SeamProfile> profiles;
  for (size_t i = 0; i < schemes_.size(); ++i)
    if (schemes_[i].isValid() && (i == shown_ || comparesSchemes()))
      profiles.push_back(schemes_[i].profile(seam_, kind.array));
  if (profiles.empty()) return {};
  ChartAxis axis = kind.axis;
  axis.begin = 0.0;
  Figure figure = continuityFigure(profiles, axis);
  std::vector<std::string> shown;
  for (const SeamProfile& profile : profiles) shown.push_back(profile.scheme);
  describeFace(*model_, shown, true, figure);
  return figure;
}

void ContinuityPanel::showProfile() {
  Figure figure = profileFigure();
  figure.title.clear();
  figure.caption.clear();
  figure.note.clear();
  if (figure.panels.empty()) figure_->setHint(faults_[shown_]);
  figure_->setFigure(figure);
}

std::string ContinuityPanel::numbers() const {
  return shown().isValid() ? tableText(shown().summary()) : std::string();
}

void ContinuityPanel::chooseRow() {
  const int row = table_->currentRow();
  if (comparesSchemes() || row < 0 || !shown().isValid()) return;
  if (isSeam(row)) seam_ = row;
  flyToRow();
  figure_->setMarked({});
  showProfile();
}

bool ContinuityPanel::isSeam(int row) const {
  return row >= 0 && row < static_cast<int>(shown().seamNames().size());
}

void ContinuityPanel::flyToRow() {
  if (comparesSchemes() || !shown().isValid()) return;
  isSeam(table_->currentRow()) ? flyToSeam() : view_->fit();
}

void ContinuityPanel::useScheme(int row) {
  if (!comparesSchemes()) return;
  model_->change([row](FaceState& state) { state.surface.scheme = faceSchemes()[row].name; });
}

void ContinuityPanel::flyToSeam() {
  const std::array<double, 6> box = shown().box(seam_);
  const std::array<double, 3> focus = {0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5])};
  double whole[6];
  shown().seams()->GetBounds(whole);
  const double rise = std::clamp(perMillimetre * (focus[1] - 0.5 * (whole[2] + whole[3])), -steepest, steepest);
  const double aspect = static_cast<double>(view_->width()) / std::max(1, view_->height());
  const double extent = seamMargin * std::max({box[3] - box[2], (box[1] - box[0]) / aspect, pointExtent});
  flight_->flyTo(focus, {0.0, rise, 1.0}, extent);
}

/// The camera stands where the face looks at it: on the ray from the axis of the head.
void ContinuityPanel::flyTo(double v) {
  if (!shown().isValid()) return;
  v = std::clamp(v, 0.0, 360.0);
  figure_->setMarked(v);
  const std::array<double, 3> point = shown().pointAt(seam_, v);
  double whole[6];
  shown().seams()->GetBounds(whole);
  const double rise = std::clamp(perMillimetre * (point[1] - 0.5 * (whole[2] + whole[3])), -steepest, steepest);
  const double x = point[0] - 0.5 * (whole[0] + whole[1]), z = point[2] - 0.5 * (whole[4] + whole[5]);
  const double radius = std::max(1.0, std::hypot(x, z));
  flight_->flyTo(point, {x / radius, rise, z / radius}, pointExtent);
}

void ContinuityPanel::paintFace() {
  const OnFace what = static_cast<OnFace>(onFace_->currentIndex());
  if (what == Skin) return overlay_->hide();
  overlay_->setSubject(what == MeanCurvature       ? tr("Curvature H")
                       : what == GaussianCurvature ? tr("Curvature K")
                                                   : onFace_->currentText());
  what == Seamlines ? paintSeams() : paintSurface(what);
}

/// Colours keep their meaning while a measure stays chosen: the range grows when it must, and never shrinks.
void ContinuityPanel::paintSeams() {
  if (!shown().isValid()) return;
  const SeamMeasureKind& kind = SeamMeasureKind::all()[measure_->currentIndex()];
  if (rangeMeasure_ != measure_->currentIndex()) range_ = kind.leastRange;
  rangeMeasure_ = measure_->currentIndex();
  for (size_t seam = 0; seam < shown().seamNames().size(); ++seam)
    range_ = std::max(
        range_, roundedUp(std::max(kind.leastRange, largestOf(shown().profile(static_cast<int>(seam), kind.array)))));
  range_ = std::min(range_, kind.largestRange);
  vtkNew<vtkPolyData> lines;
  lines->ShallowCopy(shown().seams());
  overlay_->showLines(lines, kind.array.c_str(), {QString::fromStdString(titleWithUnit(kind.axis)), 0.0, range_, {}});
}

void ContinuityPanel::paintSurface(OnFace what) {
  vtkNew<vtkPolyData> curves;
  curves->ShallowCopy(model_->pipeline().curves()->GetOutputDataObject(0));
  errors_.clear();
  fine_->SetInputData(curves);
  setParameters(model_->state().surface, fine_);
  fine_->SetResolution(fineRows, fineColumns);
  fine_->SetGenerateCurvatures(what != Zebra);
  vtkNew<vtkGeometryFilter> geometry;  // leaves the mouth open
  geometry->SetInputConnection(fine_->GetOutputPort());
  vtkNew<vtkReverseSense> outwards;
  outwards->SetInputConnection(geometry->GetOutputPort());
  fine_->Update();
  if (!errors_.first().empty()) return;
  outwards->Update();
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(outwards->GetOutput());
  const auto diverging = FaceOverlay::Colors::Diverging;
  if (what == Zebra) overlay_->showZebra(surface);
  if (what == MeanCurvature)
    overlay_->showSurface(surface, "MeanCurvature", {tr("Mean curvature H (1/mm)"), -meanRange, meanRange, diverging});
  if (what == GaussianCurvature)
    overlay_->showSurface(surface, "GaussianCurvature",
                          {tr("Gaussian curvature K (1/mm\u00b2)"), -gaussianRange, gaussianRange, diverging});
}

}  // namespace mien
