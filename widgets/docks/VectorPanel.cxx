#include "VectorPanel.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkEventQtSlotConnect.h>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <set>

#include "ElidedLabel.h"
#include "ExportButton.h"
#include "FAPSequence.h"
#include "FaceModel.h"
#include "FaceNote.h"
#include "FaceStateText.h"
#include "FlipBox.h"
#include "FramedButton.h"
#include "LiveMotion.h"
#include "LiveUpdate.h"
#include "MotionField.h"
#include "MotionTableText.h"
#include "MotionVectorFigure.h"
#include "MotionWords.h"
#include "OriginChooser.h"
#include "RenderView.h"
#include "RowScroll.h"
#include "ScreenFigure.h"
#include "Theme.h"
#include "VectorControls.h"
#include "VectorView.h"

namespace mien {

namespace {

constexpr int sideWidth = 330, originWidth = 240;  // pixels
constexpr double shape = 0.9;        // widest figure over its height with the key below: a face is upright
constexpr double faceShape = 0.82;   // width over height of a face
constexpr double keyBelowRoom = 17;  // mm, of the height
constexpr double leastWidth = 55;    // mm, of a figure with a legible key
constexpr double paperWidth = 85;    // mm, one column of a page
constexpr size_t mostSamples = 48;   // of an animation, evenly
constexpr int firstHead = 48, lastHead = 50;

/// Frames that tell how far all of an animation moves: evenly chosen ones, and the ends of the head's turns, which move
/// most.
std::vector<int> samplesOf(const FAPSequence& motion) {
  const size_t count = motion.frames.size();
  std::set<int> samples;
  for (size_t i = 0; i < mostSamples && count > 0; ++i)
    samples.insert(static_cast<int>(i * (count - 1) / (mostSamples - 1)));
  for (int fap = firstHead; fap <= lastHead && count > 0; ++fap) {
    const auto less = [fap](const FAPFrame& a, const FAPFrame& b) { return a.value(fap) < b.value(fap); };
    const auto [least, most] = std::minmax_element(motion.frames.begin(), motion.frames.end(), less);
    samples.insert(static_cast<int>(least - motion.frames.begin()));
    samples.insert(static_cast<int>(most - motion.frames.begin()));
  }
  return {samples.begin(), samples.end()};
}

}  // namespace

VectorPanel::VectorPanel(FaceModel* model, RenderView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      origin_(new OriginChooser(model, this)),
      controls_(new VectorControls(view, this)),
      figure_(new VectorView("vectorFigure", this)),
      numbers_(new ElidedLabel(this)),
      motion_(new LiveMotion(this)),
      live_(new LiveUpdate(model, this, [this] { refresh(); })) {
  setObjectName("vectorPanel");
  figure_->setToolTip(tr("Drag a rectangle to look at a region; double click or Escape for the whole face"));
  figure_->setHint(tr("Measuring motion"));
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(8, 4, 8, 6);
  whole->setSpacing(4);
  whole->addWidget(header());
  whole->addWidget(new FlipBox(side(), figure_, 0, 1, this), 1);
  connectAll();
  followCamera(view);
  followAnimation();
}

VectorPanel::~VectorPanel() = default;

/// Where the vectors start, what they come to, and what is done with the figure, as the other docks have it.
QWidget* VectorPanel::header() {
  numbers_->setObjectName("vectorsNumbers");
  numbers_->setProperty("faint", true);
  auto* box = new QWidget(this);
  box->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* fit = new QToolButton(box);
  makeFramed(
      fit, "vectorsFit", tr("Fit"),
      tr("Choose automatic scale and range anew, for all of an open animation or for what is seen now. Without an "
         "animation they grow at once and shrink only when the motion has been smaller for two seconds, so that "
         "pictures that follow each other can be compared"));
  connect(fit, &QToolButton::clicked, this, &VectorPanel::fit);
  origin_->setMinimumWidth(originWidth);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel(tr("Against"), box));
  row->addWidget(origin_);
  row->addWidget(numbers_, 1);
  row->addWidget(fit);
  row->addWidget(new ExportButton(
      "vectorsExport", model_, [this](const ExportOptions& options) { return drawing(options); },
      [this] { return numbers(); }, box));
  return box;
}

QWidget* VectorPanel::side() {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 4, 0);
  column->addWidget(controls_);
  column->addStretch();
  auto* scroll = new RowScroll(this);  // a low dock must not make the window higher
  scroll->setObjectName("vectorsSide");
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(sideWidth);
  scroll->setWidget(page);
  return scroll;
}

void VectorPanel::fit() {
  motion_->fit();
  live_->request();
}

/// Frames of a stream are not known before they come.
void VectorPanel::followAnimation() {
  samples_ = model_->isLive() ? std::vector<int>() : samplesOf(model_->motion());
  fit();
}

void VectorPanel::connectAll() {
  connect(model_, &FaceModel::animationChanged, this, &VectorPanel::followAnimation);
  connect(origin_, &OriginChooser::changed, motion_, &LiveMotion::fit);
  connect(origin_, &OriginChooser::changed, live_, &LiveUpdate::request);
  connect(controls_, &VectorControls::scaleChanged, motion_, &LiveMotion::fit);
  connect(controls_, &VectorControls::changed, live_, &LiveUpdate::request);
  connect(figure_, &VectorView::resized, live_, &LiveUpdate::request);
  connect(figure_, &VectorView::dragged, controls_, &VectorControls::setRegion);
  connect(figure_, &VectorView::wholeAsked, controls_, &VectorControls::setWholeRegion);
  connect(motion_, &LiveMotion::finished, this, &VectorPanel::show);
}

void VectorPanel::followCamera(RenderView* view) {
  cameraEvents_->Connect(view->camera(), vtkCommand::ModifiedEvent, this, SLOT(cameraMoved()));
}

void VectorPanel::cameraMoved() {
  if (controls_->followsView()) live_->request();
}

void VectorPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) live_->request();
  QWidget::changeEvent(event);
}

void VectorPanel::refresh() {
  MotionRequest request;
  request.moved = model_->lastingState();
  request.origin = origin_->origin();
  request.movedName = model_->motionText();
  request.frames = model_->frameText();
  request.originName = origin_->originName().toStdString();
  request.options = controls_->options();
  request.region = controls_->region();
  request.headMotionRemoved = controls_->headMotionRemoved();
  if (!request.moved.fapFile.empty()) request.samples = samples_;
  request.againstFrameBefore = origin_->isFrameBefore();
  fitToScreen(request);
  motion_->request(request);
}

void VectorPanel::fitToScreen(MotionRequest& request) const {
  const double height = figure_->height() * millimetresPerPixel, room = figure_->width() * millimetresPerPixel;
  request.options.height = height;
  const double heightBeside = std::min(height, (room - MotionVectorFigure::keyBesideRoom) / faceShape);
  const double heightAbove = std::min(height - keyBelowRoom, room / faceShape);
  request.options.keyBeside = heightBeside > heightAbove;  // where the face gets larger
  request.options.width = request.options.keyBeside ? room : std::min(room, std::max(leastWidth, shape * height));
  request.options.theme = screenTheme().name;
  request.options.background = Theme::current().panel;
}

void VectorPanel::show() {
  const MotionResult& result = motion_->result();
  figure_->setHint(result.fault);
  figure_->setFigure(result.figure);
  if (result.figure) controls_->showInEffect(*result.figure);
  numbers_->setText(summary());
}

QString VectorPanel::summary() const {
  const MotionResult& result = motion_->result();
  if (!result.field) return {};
  double largest = 0.0, sum = 0.0;
  int moving = 0;
  for (int row : result.chosen) {
    const double length = result.field->vectors.row(row).norm();
    largest = std::max(largest, length);
    sum += length;
    moving += length > leastMotion;
  }
  const double mean = sum / std::max<size_t>(1, result.chosen.size());
  return tr("max %1, mean %2 mm; %3 of %4 vectors move")  // the lengths first: a narrow dock cuts the end
      .arg(QString::number(largest, 'f', 2), QString::number(mean, 'f', 2))
      .arg(moving)
      .arg(result.chosen.size());
}

MotionWords VectorPanel::words() const {
  const MotionRequest& request = motion_->result().request;
  const FaceState& moved = request.moved;
  MotionWords words;
  words.moved = request.movedName;
  words.origin = request.originName;
  words.view = controls_->viewName().toStdString();
  words.made = faceNote(moved, {moved.surface.scheme}, true, request.frames) + "; " + std::to_string(moved.rows) +
               " x " + std::to_string(moved.columns);
  words.headMotionRemoved = request.headMotionRemoved;
  return words;
}

/// As the screen shows it, in the colours and the size that are asked for; scale and range chosen for that size where
/// they are open.
ExportDrawing VectorPanel::drawing(const ExportOptions& asked) const {
  const MotionResult& result = motion_->result();
  ExportDrawing drawing;
  if (!result.field) return drawing;
  MotionVectorOptions options = result.request.options;
  options.theme = asked.theme;
  options.background = asked.figureTheme().background;
  options.width = asked.width > 0.0 ? asked.width : paperWidth;
  options.height = 0.0;
  options.keyBeside = false;
  describeMotion(words(), options);
  const auto figure =
      std::make_shared<MotionVectorFigure>(std::vector<MotionVectorPanel>{{*result.field, {}}}, options);
  drawing.size = figure->size();
  drawing.paint = [figure](QPainter& painter) { figure->paint(painter); };
  drawing.title = options.title;
  drawing.description = "\nAgainst:\n" + writeFaceState(result.request.origin);
  return drawing;
}

std::string VectorPanel::numbers() const {
  const MotionResult& result = motion_->result();
  return result.field ? motionTableText(*result.field, result.chosen) : std::string();
}

}  // namespace mien
