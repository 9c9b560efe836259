#include "SmoothingPanel.h"

#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "BackgroundTask.h"
#include "BoundaryCurveData.h"
#include "ElidedLabel.h"
#include "ExportButton.h"
#include "FaceCaption.h"
#include "FaceModel.h"
#include "FaceThumbnail.h"
#include "FigureView.h"
#include "FlipBox.h"
#include "LiveUpdate.h"
#include "NumberRange.h"
#include "OverflowRow.h"
#include "SessionPart.h"
#include "SweepBreakdown.h"
#include "SweepFigure.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int rows = 112,
              columns = 80;  // of the sweep, as on the command line; doc/decisions.md has what a coarser one costs
constexpr int thumbnailRows = 83, thumbnailColumns = 80;
constexpr double stepFactor = 1.1;  // of a, by an arrow key
constexpr double smallestSmoothing = 0.001;
constexpr const char* startRange = "0.1:100:31log";
constexpr size_t mostValues = 1000;
constexpr int saidWidth = 152;         // pixels: "31 values, log spaced", or the progress and its button
constexpr int leastFigureWidth = 270;  // pixels beside the thumbnails
constexpr double fewThumbnails = 0.6;  // of them, where the key of all schemes needs the width

std::vector<ThumbnailStrip::Picture> drawPictures(const FaceCurves& face, const FaceSurfaceOptions& surface,
                                                  const std::vector<double>& values, const ThumbnailStyle& style,
                                                  const BackgroundTask::Progress& goOn) {
  std::vector<ThumbnailStrip::Picture> pictures;
  for (double a : values) {
    FaceSurfaceOptions options = surface;
    options.smoothing.fill(a);
    std::string fault = describeFault(options, face.curves.pointsPerCurve);
    ThumbnailStrip::Picture picture{a, {}, {}};
    if (fault.empty()) {
      const FaceSample sample(face, options, thumbnailRows, thumbnailColumns);
      fault = sample.fault();
      if (fault.empty()) picture.image = faceThumbnail(sample, style);
    }
    picture.reason = QString::fromStdString(fault);
    pictures.push_back(picture);
    if (!goOn(static_cast<double>(pictures.size()) / values.size())) return {};
  }
  return pictures;
}

/// A few of the values, from the first to the last.
std::vector<double> spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.size() <= ThumbnailStrip::count) return values;
  std::vector<double> few;
  for (int i = 0; i < ThumbnailStrip::count; ++i)
    few.push_back(values[i * (values.size() - 1) / (ThumbnailStrip::count - 1)]);
  return few;
}

}  // namespace

bool SmoothingPanel::Subject::asksTheSameAs(const Subject& other) const {
  return sweep.surface == other.sweep.surface && sweep.schemes == other.sweep.schemes &&
         sweep.smoothing == other.sweep.smoothing;
}

bool SmoothingPanel::Subject::sameAs(const Subject& other) const {
  return asksTheSameAs(other) && face.curves.points.rows() == other.face.curves.points.rows() &&
         face.curves.points == other.face.curves.points;
}

SmoothingPanel::SmoothingPanel(FaceModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      figure_(new FigureView("smoothingFigure", FigureView::Marker::Line, this)),
      thumbnails_(new ThumbnailStrip(this)),
      sweep_(new BackgroundTask(this)),
      pictures_(new BackgroundTask(this)),
      measure_(new QComboBox(this)),
      allSchemes_(new QCheckBox(tr("All schemes"), this)),
      range_(new QLineEdit(startRange, this)),
      said_(new QStackedWidget(this)),
      spacing_(new ElidedLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  setObjectName("smoothingPanel");
  parseNumberRange(startRange, values_);
  describeControls();
  tellSpacing();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(4);
  column->addWidget(controls());
  column->addWidget(new FlipBox(figure_, thumbnails_, 1, 0, this), 1);
  connectControls();
  new LiveUpdate(model, this, [this] { refresh(); });
}

/// The tasks are ended first: what they still deliver must find the panel whole.
SmoothingPanel::~SmoothingPanel() {
  delete sweep_;
  delete pictures_;
}

void SmoothingPanel::describeControls() {
  measure_->setObjectName("smoothingMeasure");
  measure_->setMinimumContentsLength(16);  // filled when the first sweep is there
  measure_->setToolTip(tr("What is drawn over a; departures are from the same scheme's surface at a = 1"));
  allSchemes_->setObjectName("smoothingAllSchemes");
  allSchemes_->setToolTip(tr("A line for every scheme; a marker above the plot where its surface ceases to be a face"));
  range_->setObjectName("smoothingRange");
  range_->setAccessibleName(tr("Values of a"));
  range_->setToolTip(
      tr("The values of a (no unit), as from:to:number: 0.1:100:31log is 31 values from 0.1 to 100, each the same "
         "factor larger, 0.5:2:4 four evenly spaced ones; 0.5,1,2 is a list"));
  range_->setFixedWidth(120);
  range_->setPlaceholderText(startRange);
  spacing_->setObjectName("smoothingSpacing");
  spacing_->setProperty("faint", true);
  range_->setProperty(acceptedText, range_->text());
  progress_->setObjectName("smoothingProgress");
  progress_->setToolTip(tr("How much of the sweep is computed"));
  progress_->setMaximumWidth(84);
  progress_->setRange(0, 100);
  cancel_->setObjectName("smoothingCancel");
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Ends the sweep; what was shown stays"));
  cancel_->setFocusPolicy(Qt::TabFocus);
  figure_->setToolTip(tr("Drag the line, or use the arrow keys, to set a"));
  figure_->setHint(tr("The sweep is being computed."));
  figure_->setMinimumWidth(leastFigureWidth);
}

QWidget* SmoothingPanel::controls() {
  auto* row = new OverflowRow("smoothingControls", this);
  row->addWidget(measure_);
  row->addWidget(allSchemes_);
  row->addSpacing(10);
  row->addLabelled(tr("a from : to : number"), range_, 2);
  row->addWidget(said());
  row->addStretch();
  row->addWidget(new ExportButton(
                     "smoothingExport", model_,
                     [this](const ExportOptions& options) { return ExportDrawing(sweepFigureOfAll(), options); },
                     [this] { return numbers(); }, row),
                 1);
  return row;
}

/// The range in words, and in their place how far the sweep is: nothing beside them moves.
QWidget* SmoothingPanel::said() {
  auto* sweep = new QWidget(said_);
  auto* row = new QHBoxLayout(sweep);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(progress_);
  row->addWidget(cancel_);
  row->addStretch();
  said_->addWidget(spacing_);
  said_->addWidget(sweep);
  said_->setFixedWidth(saidWidth);
  said_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  return said_;
}

void SmoothingPanel::connectControls() {
  connect(measure_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { showFigure(); });
  connect(allSchemes_, &QCheckBox::toggled, this, [this](bool on) {
    const int all = thumbnails_->sizeHint().width();
    thumbnails_->setMaximumWidth(on ? static_cast<int>(fewThumbnails * all) : QWIDGETSIZE_MAX);
    refresh();
  });
  connect(range_, &QLineEdit::editingFinished, this, [this] {
    if (readRange()) refresh();
  });
  connect(figure_, &FigureView::picked, this, &SmoothingPanel::setSmoothing);
  connect(figure_, &FigureView::stepped, this, &SmoothingPanel::step);
  connect(thumbnails_, &ThumbnailStrip::chosen, this, &SmoothingPanel::setSmoothing);
  connect(cancel_, &QToolButton::clicked, this, [this] {
    sweep_->cancel();
    cancelled_ = true;
  });
  connect(sweep_, &BackgroundTask::progressed, progress_, &QProgressBar::setValue);
  connect(sweep_, &BackgroundTask::runningChanged, this, [this](bool running) {
    said_->setCurrentIndex(running ? 1 : 0);
    if (!running && records_.empty())
      figure_->setHint(tr("The sweep was cancelled; press Return in the range of a to start it again."));
  });
  connect(model_, &FaceModel::stateChanged, this, &SmoothingPanel::markPresent);
}

/// Three decimals, as the surface dock shows it.
void SmoothingPanel::setSmoothing(double a) {
  const double rounded =
      std::clamp(std::round(1000.0 * a) / 1000.0, smallestSmoothing, FaceSurfaceOptions::largestSmoothing);
  model_->change([rounded](FaceState& state) { state.surface.smoothing.fill(rounded); });
}

void SmoothingPanel::step(int steps) {
  const auto [least, largest] = std::minmax_element(values_.begin(), values_.end());
  setSmoothing(std::clamp(model_->state().surface.smoothing.front() * std::pow(stepFactor, steps), *least, *largest));
}

/// Return starts a sweep that was cancelled again.
bool SmoothingPanel::readRange() {
  std::vector<double> values;
  std::string fault = parseNumberRange(range_->text().toStdString(), values);
  if (fault.empty() && values.size() > mostValues)
    fault = "more than 1000 values of a are too many to wait for; give fewer";
  for (double a : values)
    if (fault.empty() && !(a > 0.0 && a <= FaceSurfaceOptions::largestSmoothing))
      fault = "a = " + std::to_string(a) + " is outside 0 < a <= 1000; change the range";
  if (!fault.empty()) {
    emit model_->failed(QString::fromStdString(fault), tr("The values of a are as they were before."));
    return false;
  }
  values_ = values;
  tellSpacing();
  range_->setProperty(acceptedText, range_->text());
  if (cancelled_) subject_ = {};
  return true;
}

bool SmoothingPanel::takeSubject(Subject& subject) {
  auto* curves = vtkPolyData::SafeDownCast(model_->pipeline().curves()->GetOutputDataObject(0));
  if (!readFaceCurves(curves, subject.face).empty()) return false;
  subject.sweep.surface = model_->state().surface;
  subject.sweep.surface.smoothing.fill(1.0);  // what a is now does not matter to a sweep over a
  subject.sweep.schemes = {subject.sweep.surface.scheme};
  if (allSchemes_->isChecked()) {
    subject.sweep.schemes.clear();
    for (const FaceScheme& scheme : faceSchemes()) subject.sweep.schemes.push_back(scheme.name);
  }
  subject.sweep.smoothing = values_;
  subject.sweep.rows = rows;
  subject.sweep.columns = columns;
  return true;
}

/// In words what the field says in short.
void SmoothingPanel::tellSpacing() {
  const QString text = range_->text();
  const int count = static_cast<int>(values_.size());
  const QString values = count == 1 ? tr("1 value") : tr("%1 values").arg(count);
  const QString spacing = text.contains(',') || !text.contains(':') ? QString()
                          : text.endsWith("log")                    ? tr(", log spaced")
                                                                    : tr(", evenly spaced");
  spacing_->setText(values + spacing);
}

void SmoothingPanel::markPresent() {
  const double a = model_->state().surface.smoothing.front();
  if (!figure_->figure().panels.empty() && a > figure_->figure().panels.front().x.end.value_or(a)) showFigure();
  figure_->setMarked(a);
  figure_->setMarkerName(tr("this face, a = %1").arg(a));
}

void SmoothingPanel::refresh() {
  markPresent();
  Subject subject;
  if (!takeSubject(subject) || subject.sameAs(subject_)) return;
  const bool onlyMoves = subject.asksTheSameAs(subject_);  // a face that keeps moving would never see a sweep end
  subject_ = subject;
  startSweep(onlyMoves);
  startThumbnails();
}

void SmoothingPanel::startSweep(bool afterTheLast) {
  const Subject subject = subject_;
  cancelled_ = false;
  sweep_->start(
      [this, subject](const BackgroundTask::Progress& goOn) -> std::function<void()> {
        const auto records = smoothingSweep(subject.face, subject.sweep, goOn);
        if (!records) return {};
        return [this, found = *records, sweep = subject.sweep] {
          records_ = found;
          swept_ = sweep;
          showFigure();
        };
      },
      afterTheLast ? BackgroundTask::Before::Finishes : BackgroundTask::Before::Ends);
}

void SmoothingPanel::startThumbnails() {
  const Theme& theme = Theme::current();
  ThumbnailStyle style{
      QSize(ThumbnailStrip::side * 3 / 4, ThumbnailStrip::side) * devicePixelRatioF(), {}, {}, theme.skin, {}, 0.0};
  style.frame(subject_.face);
  pictures_->start(
      [this, subject = subject_, style](const BackgroundTask::Progress& goOn) -> std::function<void()> {
        const auto pictures =
            drawPictures(subject.face, subject.sweep.surface, spread(subject.sweep.smoothing), style, goOn);
        return [this, pictures] { thumbnails_->setPictures(pictures); };
      },
      BackgroundTask::Before::Finishes);
}

Figure SmoothingPanel::sweepFigureOfAll() const {
  if (records_.empty()) return {};
  std::map<std::string, double> breakdowns;
  for (const SweepBreakdown& breakdown : findBreakdowns(records_))
    if (breakdown.found) breakdowns[breakdown.scheme] = breakdown.smoothing;
  Figure figure = sweepFigure(records_, breakdowns, swept_.reference);
  figure.note = "grid " + std::to_string(rows) + " x " + std::to_string(columns);
  describeFace(*model_, swept_.schemes, false, figure);
  return figure;
}

/// An axis that ends behind the breakdowns goes on to the face that is shown.
void SmoothingPanel::reachPresent(Chart& panel) const {
  const double a = model_->state().surface.smoothing.front();
  const double last = *std::max_element(values_.begin(), values_.end());
  if (panel.x.end && a > *panel.x.end) panel.x.end = a < last ? std::optional<double>(a) : std::nullopt;
}

void SmoothingPanel::showFigure() {
  const Figure all = sweepFigureOfAll();
  if (all.panels.empty()) return;
  if (measure_->count() != static_cast<int>(all.panels.size())) {
    const QSignalBlocker quiet(measure_);
    const QString chosen = measure_->currentText();
    measure_->clear();
    for (const Chart& panel : all.panels) measure_->addItem(QString::fromStdString(titleWithUnit(panel.y)));
    measure_->setCurrentIndex(std::max(0, measure_->findText(chosen)));
  }
  Figure shown;
  shown.panels = {all.panels[measure_->currentIndex()]};
  reachPresent(shown.panels.front());
  shown.panels.front().x.title = sweepAxisTitle(shown.panels.front());
  figure_->setFigure(shown);
}

std::string SmoothingPanel::numbers() const {
  if (records_.empty()) return {};
  std::ostringstream text;
  text.precision(10);
  text << "scheme,a";
  for (const std::string& name : sweepMeasureNames()) text << "," << name;
  for (const SweepRecord& record : records_) {
    text << "\n" << record.scheme << "," << record.smoothing;
    for (double value : record.values) text << "," << value;
  }
  text << "\n";
  return text.str();
}

}  // namespace mien
