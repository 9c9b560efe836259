#include "FAPPlotPanel.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "AnimationPlayer.h"
#include "ExportButton.h"
#include "FAPTable.h"
#include "FAPText.h"
#include "FaceModel.h"
#include "FigureView.h"
#include "NumberText.h"
#include "SeriesStyle.h"
#include "SeriesSwatch.h"

namespace mien {

namespace {

constexpr size_t atFirst = 4;         // FAPs shown of a new animation
constexpr int listWidth = 290;        // pixels: the longest name
constexpr double zoomStep = 1.6;      // of a button
constexpr double fewestFrames = 4.0;  // in the plot
constexpr double headRadius = 100.0;  // mm: what an angle of the head moves, to compare it with distances
constexpr int growthWait = 200;       // ms between pictures of a stream that grows

int fapOf(const QListWidgetItem* item) {
  return item->data(Qt::UserRole).toInt();
}

/// A FAP that is plotted like others but does nothing here.
void markAsStill(QListWidgetItem* item, const FAPDefinition& fap) {
  item->setText(item->text() +
                (fap.hasSurface ? FAPPlotPanel::tr(" (not in the table)") : FAPPlotPanel::tr(" (no surface)")));
  QFont font = item->font();
  font.setItalic(true);
  item->setFont(font);
  item->setToolTip(item->toolTip() +
                   (fap.hasSurface ? FAPPlotPanel::tr("<br>The animation table has no entry for it: nothing moves")
                                   : FAPPlotPanel::tr("<br>This face has no surface for it: nothing moves")));
}

/// How far the values of one FAP reach from each other.
double rangeOf(const FAPSequence& motion, int fap) {
  double least = 0.0, most = 0.0;
  for (const FAPFrame& frame : motion.frames) {
    least = std::min(least, frame.value(fap));
    most = std::max(most, frame.value(fap));
  }
  return most - least;
}

QToolButton* button(QWidget* parent, const char* name, const QString& text, const QString& tip) {
  auto* made = new QToolButton(parent);
  made->setObjectName(name);
  made->setText(text);
  made->setToolTip(tip);
  made->setProperty("framed", true);
  made->setFocusPolicy(Qt::TabFocus);
  return made;
}

}  // namespace

FAPPlotPanel::FAPPlotPanel(FaceModel* model, AnimationPlayer* player, QWidget* parent)
    : QWidget(parent),
      model_(model),
      player_(player),
      figure_(new FigureView("plotFigure", FigureView::Marker::Line, this)),
      list_(new QListWidget(this)),
      hint_(new QLabel(this)),
      growth_(new QTimer(this)) {
  setObjectName("fapPlotPanel");
  growth_->setSingleShot(true);
  growth_->setInterval(growthWait);
  list_->setObjectName("plotFAPs");
  list_->setSelectionMode(QAbstractItemView::MultiSelection);
  list_->setIconSize(swatchSize);
  list_->setFixedWidth(listWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setToolTip(
      tr("Click the FAPs to plot, six at most. Listed is what the animation changes; visemes and expressions count as "
         "the FAPs that they stand for"));
  figure_->setToolTip(
      tr("Drag to scrub; wheel to zoom; drag with Shift for the range to play; arrow keys step by frames"));
  auto* body = new QHBoxLayout;
  body->addWidget(list_);
  body->addWidget(figure_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(4);
  column->addWidget(controls());
  column->addLayout(body, 1);
  connectAll();
}

FAPPlotPanel::~FAPPlotPanel() = default;

QWidget* FAPPlotPanel::controls() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  hint_->setObjectName("plotHint");
  hint_->setProperty("faint", true);
  auto* nearer = button(box, "plotZoomIn", tr("+"), tr("Show a shorter time around the line (wheel)"));
  auto* further = button(box, "plotZoomOut", tr("\u2212"), tr("Show a longer time (wheel)"));
  auto* whole = button(box, "plotWhole", tr("Whole"), tr("Show the whole animation"));
  auto* range = button(box, "plotRange", tr("Range"), tr("Show the range that is played"));
  const auto cursor = [this] { return model_->framePosition() / model_->motion().framesPerSecond; };
  connect(nearer, &QToolButton::clicked, this, [this, cursor] { zoom(cursor(), 1.0 / zoomStep); });
  connect(further, &QToolButton::clicked, this, [this, cursor] { zoom(cursor(), zoomStep); });
  connect(whole, &QToolButton::clicked, this, [this] { showTimes(0.0, duration()); });
  connect(range, &QToolButton::clicked, this, [this] {
    const double rate = model_->motion().framesPerSecond;
    showTimes(player_->rangeBegin() / rate, player_->rangeEnd() / rate);
  });
  row->addWidget(hint_, 1);
  for (QWidget* widget : {nearer, further, whole, range}) row->addWidget(widget);
  row->addWidget(new ExportButton(
      "plotExport", model_, [this](const ExportOptions& options) { return ExportDrawing(fullFigure(), options); },
      [this] { return numbers(); }, box));
  return box;
}

void FAPPlotPanel::connectAll() {
  connect(model_, &FaceModel::animationChanged, this, [this] {
    asked_.reset();
    outdated_ = true;
    if (isVisible()) followAnimation();
  });
  connect(growth_, &QTimer::timeout, this, &FAPPlotPanel::followGrowth);
  connect(model_, &FaceModel::animationGrew, this, [this] {
    if (!growth_->isActive()) growth_->start();
  });
  connect(model_, &FaceModel::stateChanged, this, &FAPPlotPanel::followFrame);
  connect(player_, &AnimationPlayer::rangeChanged, this, &FAPPlotPanel::followRange);
  connect(list_, &QListWidget::itemSelectionChanged, this, &FAPPlotPanel::choose);
  connect(figure_, &FigureView::picked, this, [this](double time) {
    const double position = time * model_->motion().framesPerSecond;
    player_->seek(model_->interpolates() ? position : std::round(position));
  });
  connect(figure_, &FigureView::stepped, this, [this](int steps) { player_->seek(model_->frameIndex() + steps); });
  connect(figure_, &FigureView::zoomed, this, &FAPPlotPanel::zoom);
  connect(figure_, &FigureView::bandDragged, this, [this](double from, double to) {
    const double rate = model_->motion().framesPerSecond;
    player_->setRange(static_cast<int>(std::lround(from * rate)), static_cast<int>(std::lround(to * rate)));
  });
}

void FAPPlotPanel::showEvent(QShowEvent* event) {
  if (outdated_) followAnimation();
  followFrame();
  QWidget::showEvent(event);
}

void FAPPlotPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) drawSwatches();
  QWidget::changeEvent(event);
}

double FAPPlotPanel::duration() const {
  return model_->motion().frames.empty() ? 1.0 : model_->motion().duration();
}

void FAPPlotPanel::followAnimation() {
  outdated_ = false;
  begin_ = 0.0;
  end_ = duration();
  listFAPs();
  asked_ ? select(*asked_) : chooseSome();
  followRange();
  followFrame();
}

/// More of the same animation: what was chosen stays, and what is shown still ends with the newest frame if it did.
void FAPPlotPanel::followGrowth() {
  if (outdated_ || !isVisible()) {
    outdated_ = true;
    return;
  }
  if (chosen_.empty()) return followAnimation();
  const std::vector<PlottedFAP> chosen = chosen_;
  const double before = known_;
  const bool fromStart = !(begin_ > 0.0), toEnd = end_ >= before;
  listFAPs();
  chosen_ = chosen;
  {
    const QSignalBlocker quiet(list_);
    for (int i = 0; i < list_->count(); ++i)
      for (const PlottedFAP& plotted : chosen_)
        if (plotted.fap == fapOf(list_->item(i))) list_->item(i)->setSelected(true);
  }
  const double step = toEnd ? duration() - before : 0.0;
  end_ += step;
  if (!fromStart) begin_ += step;
  followChoice();
  followFrame();
}

void FAPPlotPanel::listFAPs() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  chosen_.clear();
  known_ = duration();
  int still = 0;
  for (const FAPDefinition& fap : fapTable) {
    if (fap.number < FAPFrame::firstLowLevel || !(rangeOf(model_->motion(), fap.number) > 0.0)) continue;
    auto* item = new QListWidgetItem(seriesSwatch(-1), QString("%1 %2").arg(fap.number).arg(fapLabel(fap)), list_);
    item->setData(Qt::UserRole, fap.number);
    item->setToolTip(fapToolTip(fap, model_->millimetresPerUnit(fap.number)));
    if (model_->moves(fap.number)) continue;
    ++still;
    markAsStill(item, fap);
  }
  const QString counted =
      still > 0 ? tr("%1 FAPs change, %2 of them without effect on this face").arg(list_->count()).arg(still)
                : tr("%1 FAPs change").arg(list_->count());
  hint_->setText(list_->count() > 0 ? tr("%1; click to plot, six at most").arg(counted) : QString());
  figure_->setHint(model_->frameCount() == 0 ? tr("Open a .fap animation to plot its FAPs")
                   : list_->count() == 0     ? tr("No FAP of this animation ever moves")
                                             : tr("Click FAPs in the list to plot them"));
}

/// Those that move the face furthest, of mirror partners one; they come first, and later clicks move nothing.
void FAPPlotPanel::chooseSome() {
  const auto reach = [this](int fap) {
    const double millimetres = model_->millimetresPerUnit(fap);
    return rangeOf(model_->motion(), fap) * (millimetres > 0.0 ? millimetres : radiansPerAngleUnit * headRadius);
  };
  std::vector<std::pair<double, QListWidgetItem*>> items;
  for (int i = 0; i < list_->count(); ++i)
    if (model_->moves(fapOf(list_->item(i)))) items.emplace_back(reach(fapOf(list_->item(i))), list_->item(i));
  std::stable_sort(items.begin(), items.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  const QSignalBlocker quiet(list_);
  std::vector<int> faps;
  for (const auto& [distance, item] : items) {
    const bool partnerIsThere = std::count(faps.begin(), faps.end(), fapDefinition(fapOf(item)).mirrorPartner) > 0;
    if (partnerIsThere || faps.size() == atFirst) continue;
    list_->insertItem(static_cast<int>(faps.size()), list_->takeItem(list_->row(item)));  // the list is the legend too
    faps.push_back(fapOf(item));
    item->setSelected(true);
  }
  list_->scrollToTop();
  followChoice();
}

void FAPPlotPanel::choose() {
  followChoice();
  asked_.emplace();
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->isSelected()) asked_->push_back(fapOf(list_->item(i)));
}

void FAPPlotPanel::select(const std::vector<int>& faps) {
  {
    const QSignalBlocker quiet(list_);
    for (int i = 0; i < list_->count(); ++i)
      list_->item(i)->setSelected(std::count(faps.begin(), faps.end(), fapOf(list_->item(i))) > 0);
  }
  followChoice();
}

nlohmann::json FAPPlotPanel::sessionState() const {
  if (!asked_) return nlohmann::json::object();
  return {{"faps", *asked_}};
}

void FAPPlotPanel::restoreSession(const nlohmann::json& state) {
  asked_.reset();
  if (state.is_object() && state.contains("faps") && state["faps"].is_array()) {
    asked_.emplace();
    for (const auto& fap : state["faps"])
      if (fap.is_number_integer()) asked_->push_back(fap.get<int>());
  }
  if (outdated_) return;
  select(asked_.value_or(std::vector<int>()));
  if (!asked_) chooseSome();
}

/// A FAP keeps its colour as long as it stays chosen.
void FAPPlotPanel::followChoice() {
  const auto isGone = [this](const PlottedFAP& plotted) {
    for (int i = 0; i < list_->count(); ++i)
      if (fapOf(list_->item(i)) == plotted.fap) return !list_->item(i)->isSelected();
    return true;
  };
  chosen_.erase(std::remove_if(chosen_.begin(), chosen_.end(), isGone), chosen_.end());
  for (int i = 0; i < list_->count(); ++i)
    if (list_->item(i)->isSelected()) addChosen(list_->item(i));
  drawSwatches();
  draw();
}

void FAPPlotPanel::addChosen(QListWidgetItem* item) {
  const int fap = fapOf(item);
  for (const PlottedFAP& plotted : chosen_)
    if (plotted.fap == fap) return;
  for (int style = 0; style < SeriesStyle::count; ++style) {
    const auto has = [style](const PlottedFAP& plotted) { return plotted.style == style; };
    if (std::none_of(chosen_.begin(), chosen_.end(), has))
      return chosen_.push_back({fap, item->text().toStdString(), style});
  }
  hint_->setText(tr("Six at most can be told apart: click one away first"));
  const QSignalBlocker quiet(list_);
  item->setSelected(false);
}

void FAPPlotPanel::drawSwatches() {
  for (int i = 0; i < list_->count(); ++i) {
    int style = -1;
    for (const PlottedFAP& plotted : chosen_)
      if (plotted.fap == fapOf(list_->item(i))) style = plotted.style;
    list_->item(i)->setIcon(seriesSwatch(style));
  }
}

/// While playing, what is shown follows the line from page to page.
void FAPPlotPanel::followFrame() {
  if (!isVisible() || outdated_) return;
  const double time = model_->framePosition() / model_->motion().framesPerSecond;
  const double width = end_ - begin_;
  if (player_->isPlaying() && (time < begin_ || time > end_)) showTimes(time, time + width);
  figure_->setMarked(model_->frameCount() > 0 ? std::make_optional(time) : std::nullopt);
}

void FAPPlotPanel::followRange() {
  const double rate = model_->motion().framesPerSecond;
  const auto band = std::make_pair(player_->rangeBegin() / rate, player_->rangeEnd() / rate);
  figure_->setBand(player_->hasRange() ? std::make_optional(band) : std::nullopt);
}

void FAPPlotPanel::zoom(double time, double factor) {
  showTimes(time + factor * (begin_ - time), time + factor * (end_ - time));
}

/// Moved into the animation, and never shorter than a few frames.
void FAPPlotPanel::showTimes(double begin, double end) {
  const double shortest = std::min(fewestFrames / model_->motion().framesPerSecond, duration());
  const double width = std::clamp(end - begin, shortest, std::max(shortest, duration()));
  begin_ = std::clamp(0.5 * (begin + end - width), 0.0, std::max(0.0, duration() - width));
  end_ = begin_ + width;
  draw();
}

void FAPPlotPanel::draw() {
  std::vector<PlottedFAP> plotted = chosen_;
  for (PlottedFAP& fap : plotted) fap.name.clear();  // the list is the legend
  Figure figure = fapPlotFigure(model_->motion(), plotted, begin_, end_);
  figure.title.clear();  // the dock's
  figure_->setFigure(figure);
}

Figure FAPPlotPanel::fullFigure() const {
  Figure figure = fapPlotFigure(model_->motion(), chosen_, begin_, end_);
  figure.note = QFileInfo(QString::fromStdString(model_->state().fapFile)).fileName().toStdString() + ", " +
                QString::number(model_->framesPerSecond()).toStdString() +
                " frames/s; 1024 units are the whole length of a FAP's unit";
  return figure;
}

/// Of all frames, whatever the plot shows of them.
std::string FAPPlotPanel::numbers() const {
  const FAPSequence& motion = model_->motion();
  if (chosen_.empty()) return {};
  std::string text = "frame,time_s";
  for (const PlottedFAP& plotted : chosen_)
    text += ",fap" + std::to_string(plotted.fap) + "_" + std::string(fapDefinition(plotted.fap).name);
  for (size_t i = 0; i < motion.frames.size(); ++i) {
    appendNumber(text += '\n', motion.frames[i].number);
    appendNumber(text += ',', motion.timeOfFrame(i));
    for (const PlottedFAP& plotted : chosen_) appendNumber(text += ',', motion.frames[i].value(plotted.fap));
  }
  text += '\n';
  return text;
}

}  // namespace mien
