#include "SpectrumPanel.h"

#include <vtkDoubleArray.h>
#include <vtkGeometryFilter.h>
#include <vtkMath.h>
#include <vtkPDEModeFilter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkReverseSense.h>
#include <vtkStructuredGrid.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "CsvTable.h"
#include "ExportButton.h"
#include "FaceCaption.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "FigureView.h"
#include "LiveUpdate.h"
#include "RoundedUp.h"
#include "SpectrumFigure.h"
#include "SurfaceParameters.h"

namespace mien {

namespace {

constexpr const char* lengthArray = "ContributionLength";
constexpr SpectrumPart measures[] = {SpectrumPart::Length, SpectrumPart::Energy};  // of the list

std::vector<ModeMeasures> measuresOf(vtkTable* table) {
  std::vector<ModeMeasures> all;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row) {
    const auto number = [&](const char* name) { return table->GetValueByName(row, name).ToDouble(); };
    all.push_back({table->GetValueByName(row, "mode").ToString(), number("rms_mm"), number("max_mm"),
                   number("energy_share"), number("cumulative_rms_error_mm")});
  }
  return all;
}

/// Mode 0 carries the place of the face: its length is taken from its middle, or the origin would decide.
void addLengths(vtkPolyData* surface, bool centred) {
  vtkDataArray* contribution = surface->GetPointData()->GetArray("Contribution");
  const vtkIdType count = contribution->GetNumberOfTuples();
  double middle[3] = {0, 0, 0};
  for (vtkIdType i = 0; centred && i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) middle[axis] += contribution->GetComponent(i, axis) / count;
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName(lengthArray);
  lengths->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
    lengths->SetValue(i, std::sqrt(vtkMath::Distance2BetweenPoints(contribution->GetTuple3(i), middle)));
  surface->GetPointData()->AddArray(lengths);
}

/// On a logarithmic axis the smallest bar would have no height where it ends at a decade.
void leaveRoomBelow(Chart& chart) {
  double least = 1e300, largest = 0.0;
  for (double value : chart.series.front().y) {
    if (value > 0.0) least = std::min(least, value);
    if (std::isfinite(value)) largest = std::max(largest, value);
  }
  constexpr double manyTimes = 50.0, room = 0.5;
  if (largest <= manyTimes * least) return;
  chart.y.scale = ChartAxis::Scale::Logarithmic;
  chart.y.begin = room * least;
}

}  // namespace

SpectrumPanel::SpectrumPanel(FaceModel* model, FaceView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      figure_(new FigureView("spectrumFigure", FigureView::Marker::Band, this)),
      overlay_(new FaceOverlay(view, tr("Spectrum"), this)),
      measure_(new QComboBox(this)),
      mode_(new QComboBox(this)),
      partial_(new QCheckBox(tr("Partial sum"), this)),
      onFace_(new QToolButton(this)),
      numbers_(new QLabel(this)) {
  setObjectName("spectrumPanel");
  errors_.observe(modes_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(4);
  column->addWidget(controls());
  column->addWidget(figure_, 1);
  column->addWidget(numbers_);
  connectControls();
  new LiveUpdate(
      model, this, [this] { refresh(); }, [this] { return overlay_->isShown(); });
}

SpectrumPanel::~SpectrumPanel() = default;

QWidget* SpectrumPanel::controls() {
  measure_->setObjectName("spectrumMeasure");
  measure_->setAccessibleName(tr("Measure"));
  measure_->addItems({tr("RMS (mm)"), tr("Share of the energy")});
  measure_->setToolTip(
      tr("What the bars show: the RMS length of S<sub>n</sub>(u, v) in mm, or its square's share of the sum over all "
         "modes (no unit)"));
  mode_->setObjectName("spectrumMode");
  mode_->setToolTip(
      tr("The Fourier mode n; modes up to N are solved exactly, all others follow together as the remainder"));
  onFace_->setObjectName("spectrumOnFace");
  onFace_->setText(tr("On the face"));
  onFace_->setCheckable(true);
  onFace_->setFocusPolicy(Qt::TabFocus);
  onFace_->setToolTip(tr("Colours the face by the length of S<sub>n</sub>(u, v), in mm; again: the plain skin"));
  partial_->setObjectName("spectrumPartial");
  partial_->setToolTip(tr("The face takes the shape of modes 0 .. n alone while a mode is shown on it"));
  figure_->setToolTip(tr("Click a bar, or use the arrow keys, to see what that mode adds to the face"));
  numbers_->setObjectName("spectrumNumbers");
  numbers_->setProperty("faint", true);
  numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  numbers_->setMinimumWidth(1);
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(measure_);
  row->addWidget(new QLabel(tr("Mode"), box));
  row->addWidget(mode_);
  row->addWidget(onFace_);
  row->addWidget(partial_);
  row->addStretch();
  row->addWidget(new ExportButton(
      "spectrumExport", model_, [this](const ExportOptions& options) { return ExportDrawing(shownFigure(), options); },
      [this] { return rowCount() ? tableText(modes_->GetSpectrum()) : std::string(); }, box));
  return box;
}

void SpectrumPanel::connectControls() {
  connect(measure_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { showFigure(); });
  connect(mode_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &SpectrumPanel::choose);
  connect(figure_, &FigureView::picked, this, [this](double x) { choose(static_cast<int>(std::lround(x))); });
  connect(figure_, &FigureView::stepped, this, [this](int steps) { choose(row_ + steps); });
  connect(partial_, &QCheckBox::toggled, this, [this] { refresh(); });
  connect(onFace_, &QToolButton::toggled, this, [this](bool on) {
    if (!on) return overlay_->hide();
    if (!overlay_->isShown() && (rowCount() > 0 || measure())) paintFace();
  });
  connect(overlay_, &FaceOverlay::shownChanged, onFace_, &QToolButton::setChecked);
}

int SpectrumPanel::rowCount() const {
  return static_cast<int>(modes_->GetSpectrum()->GetNumberOfRows());
}

void SpectrumPanel::choose(int row) {
  if (rowCount() == 0) return;
  row_ = std::clamp(row, 0, rowCount() - 1);
  if (!measure()) return;
  showNumbers();
  paintFace();
}

/// Runs the filter; the model shows only states that have a surface, so a fault here is a rare one, and said in the
/// dock.
bool SpectrumPanel::measure() {
  const FaceSurfaceOptions& surface = model_->state().surface;
  const int rows = surface.modes + (surface.remainder ? 2 : 1);
  row_ = std::min(row_, rows - 1);
  vtkNew<vtkPolyData> curves;
  curves->ShallowCopy(model_->pipeline().curves()->GetOutputDataObject(0));
  errors_.clear();
  modes_->SetInputData(curves);
  setParameters(surface, modes_);
  modes_->SetResolution(model_->state().rows, model_->state().columns);
  modes_->SetUniformRows(model_->state().uniformRows);
  modes_->SetMode(row_ > surface.modes ? -1 : row_);
  modes_->SetPartialSum(partial_->isChecked());
  modes_->Update();
  if (errors_.first().empty()) return true;
  modes_->GetSpectrum()->Initialize();
  figure_->setHint(QString::fromStdString(errors_.first()));
  figure_->setFigure({});
  return false;
}

void SpectrumPanel::refresh() {
  if (!measure()) return;
  listModes();
  showFigure();
  showNumbers();
  if (overlay_->isShown()) paintFace();
}

void SpectrumPanel::listModes() {
  if (mode_->count() == rowCount()) return;
  const QSignalBlocker quiet(mode_);
  mode_->clear();
  for (const ModeMeasures& mode : measuresOf(modes_->GetSpectrum())) mode_->addItem(QString::fromStdString(mode.mode));
}

/// There is one scheme, and the surface dock names it.
Figure SpectrumPanel::shownFigure() const {
  if (rowCount() == 0) return {};
  const FaceSurfaceOptions& surface = model_->state().surface;
  Figure figure = spectrumFigure({{surface.scheme, measuresOf(modes_->GetSpectrum())}}, {},
                                 {measures[measure_->currentIndex()], SpectrumPart::Missing});
  for (Chart& panel : figure.panels) leaveRoomBelow(panel);
  describeFace(*model_, {surface.scheme}, true, figure);
  return figure;
}

void SpectrumPanel::showFigure() {
  Figure shown;
  shown.panels = shownFigure().panels;
  shown.columns = 2;
  if (!shown.panels.empty()) figure_->setFigure(shown);
}

void SpectrumPanel::showNumbers() {
  const ModeMeasures mode = measuresOf(modes_->GetSpectrum())[row_];
  const QSignalBlocker quiet(mode_);
  mode_->setCurrentIndex(row_);
  figure_->setMarked(row_);
  const QString name =
      mode.mode == "remainder" ? tr("Remainder") : tr("Mode %1").arg(QString::fromStdString(mode.mode));
  numbers_->setText(tr("%1: RMS %2 mm, at most %3 mm, %4 % of the energy; the sum up to here lacks %5 mm RMS")
                        .arg(name, QString::number(mode.rms, 'g', 4), QString::number(mode.max, 'g', 4),
                             QString::number(100.0 * mode.energyShare, 'g', 3),
                             QString::number(mode.cumulativeError, 'g', 3)));
}

/// Colours keep their meaning while a mode stays chosen: the range grows when it must, and never shrinks.
double SpectrumPanel::colorRange(double largest) {
  if (rangeRow_ != row_) range_ = 0.0;
  rangeRow_ = row_;
  range_ = std::max(range_, roundedUp(largest));
  return range_;
}

void SpectrumPanel::paintFace() {
  vtkNew<vtkGeometryFilter> geometry;  // leaves the mouth open
  geometry->SetInputData(vtkStructuredGrid::SafeDownCast(modes_->GetOutputDataObject(0)));
  vtkNew<vtkReverseSense> outwards;
  outwards->SetInputConnection(geometry->GetOutputPort());
  outwards->Update();
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(outwards->GetOutput());
  addLengths(surface, row_ == 0);
  const double largest = surface->GetPointData()->GetArray(lengthArray)->GetRange()[1];
  const QString name = mode_->itemText(row_);
  const QString subject = name == "remainder" ? tr("Remainder") : tr("Mode %1").arg(name);
  overlay_->setSubject(subject);
  overlay_->showSurface(
      surface, lengthArray,
      {tr("%1, length (mm)").arg(subject), 0.0, colorRange(largest), FaceOverlay::Colors::Sequential});
}

}  // namespace mien
