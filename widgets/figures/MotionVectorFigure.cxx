#include "MotionVectorFigure.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "VectorScale.h"

namespace mien {

namespace {

constexpr double leastPicture = 38.0;   // mm
constexpr double leastAsked = 20.0;     // mm, of panels whose number in a row is asked for
constexpr double pictureGap = 3.0;      // mm
constexpr double pictureRowGap = 3.0;   // mm
constexpr double wordsGap = 2.0;        // mm, above caption and note
constexpr double referenceRoom = 0.25;  // longest reference arrow over width of the figure
constexpr double keyGap = 2.5;          // mm, above the key
constexpr double besideGap = 4.0;       // mm, before a key beside the panels
constexpr double arrowRoom = 0.085;     // longest arrow over width of a panel: neighbours still can be told apart
constexpr double seriesRoom = 0.13;     // the same in a row of frames, where most of them move less than the longest
constexpr double mostShape = 1.5;       // height over width of a panel
constexpr double leastEqual = 0.01;     // of the longest vector: shorter ones have no arrow of equal length
constexpr double leastFace = 8.0;       // mm, of a panel that the key leaves hardly any room
constexpr int refinements = 5;          // size of the face and overhang of arrows depend on each other, weakly

QString label(size_t index, size_t count, const std::string& heading) {
  const QString text = QString::fromStdString(heading);
  if (count < 2) return text;
  const QString letter =
      '(' + QString(QChar('a' + static_cast<char>(index % 26))) + (index < 26 ? "" : QString::number(index / 26)) + ')';
  return text.isEmpty() ? letter : letter + ' ' + text;
}

/// A frame is never empty, so that a figure without a surface still can be drawn.
Eigen::AlignedBox2d usable(const Eigen::AlignedBox2d& frame) {
  if (frame.isEmpty()) return {Eigen::Vector2d(-1.0, -1.0), Eigen::Vector2d(1.0, 1.0)};
  const Eigen::Vector2d lack = (1e-6 - frame.sizes().array()).max(0.0).matrix();
  return {frame.min() - lack, frame.max() + lack};
}

}  // namespace

MotionVectorFigure::MotionVectorFigure(const std::vector<MotionVectorPanel>& panels, const MotionVectorOptions& options)
    : options_(options), style_(options), inner_(figureUnits(options.width - 2.0 * FigureWords::border)) {
  prepare(panels, static_cast<int>(panels.size()));
  for (size_t i = 0; i < all_.size(); ++i)
    panels_.emplace_back(all_[i], label(i, options_.labelled ? all_.size() : 1, panels[i].heading));
  layOut();
}

MotionVectorFigure::MotionVectorFigure(const std::vector<MotionVectorPanel>& panels, size_t only,
                                       const MotionVectorOptions& options)
    : options_(options), style_(options), inner_(figureUnits(options.width - 2.0 * FigureWords::border)) {
  prepare(panels, 1);
  panels_.emplace_back(all_.at(only), label(0, 1, panels.at(only).heading));
  layOut();
}

void MotionVectorFigure::prepare(const std::vector<MotionVectorPanel>& panels, int shown) {
  size_.setWidth(figureUnits(options_.width));
  const double cell = cellWidth(columnCount(shown)) / figureUnitsPerMillimetre;
  const double highest = mostShape * cell;
  options_.picture.paper = {cell, options_.height > 0.0 ? std::min(options_.height, highest) : highest};
  for (const MotionVectorPanel& panel : panels) addPicture(panel.field);
  if (style_.length == MotionVectorOptions::Length::Equal) leaveOutRipple();
  frame_ = usable(frame_);
  chooseRange();
  const std::string sampling = options_.picture.sampling.description();
  const std::string note = options_.note.empty() ? "" : options_.note + "; " + sampling;
  words_.emplace(options_.title, options_.caption, note, options_.width, style_.family);
}

/// All panels of a series are sampled as the first one is.
void MotionVectorFigure::addPicture(const MotionField& field) {
  VectorPicture picture = drawnVectors(field, options_.picture);
  options_.picture.sampling = picture.sampling;
  if (!options_.seams) picture.seams.clear();
  frame_.extend(picture.frame);
  const bool inSpace = options_.length == MotionVectorOptions::Length::InSpace;
  longest_ = std::max(longest_, inSpace ? picture.largest() : picture.longest());
  all_.push_back(std::move(picture));
}

/// Equal arrows would show what is nothing but rounding as large as a movement.
void MotionVectorFigure::leaveOutRipple() {
  double largest = 0.0;
  for (const VectorPicture& picture : all_) largest = std::max(largest, picture.largest());
  style_.leastShown = leastEqual * largest;
  for (VectorPicture& picture : all_) {
    const auto isRipple = [&](const PictureArrow& arrow) { return arrow.magnitude < style_.leastShown; };
    const auto end = std::remove_if(picture.arrows.begin(), picture.arrows.end(), isRipple);
    picture.still += static_cast<int>(picture.arrows.end() - end);
    picture.arrows.erase(end, picture.arrows.end());
  }
}

/// Motion in space starts at 0; motion towards the viewer reaches as far to either side, and at least as far as a tenth
/// of the motion in space, so that motion within the picture has the colour of zero.
void MotionVectorFigure::chooseRange() {
  double least = 0.0, most = 0.0;
  for (const VectorPicture& picture : all_)
    for (const PictureArrow& arrow : picture.arrows) {
      least = std::min(least, style_.coloredValue(arrow));
      most = std::max(most, style_.coloredValue(arrow));
    }
  const bool isSigned = style_.color == MotionVectorOptions::Color::Towards;
  double largest = 0.0;
  for (const VectorPicture& picture : all_) largest = std::max(largest, picture.largest());
  style_.lacksTowards = isSigned && !options_.range && std::max(most, -least) < leastMotion && largest > 0.0;
  const double end = automaticRangeEnd(std::max({most, -least, isSigned ? leastTowards * largest : 0.0}));
  const std::array<double, 2> automatic = {isSigned ? -end : 0.0, end};
  std::tie(style_.rangeBegin, style_.rangeEnd) = std::tuple_cat(options_.range.value_or(automatic));
  const double rounding = 1e-9 * (style_.rangeEnd - style_.rangeBegin);
  const bool moves = longest_ > 0.0 || most > 0.0;
  beyond_ = {moves && least < style_.rangeBegin - rounding, moves && most > style_.rangeEnd + rounding};
}

void MotionVectorFigure::chooseScale(double room) {
  arrowRoom_ = room;
  style_.scale = options_.scale.value_or(scaleFor(longest_));
}

double MotionVectorFigure::scaleFor(double longest) const {
  return automaticScale(longest, arrowRoom_ / figureUnitsPerMillimetre);
}

double MotionVectorFigure::panelsWidth() const {
  return options_.keyBeside ? std::max(figureUnits(leastPicture), inner_ - figureUnits(keyBesideRoom)) : inner_;
}

int MotionVectorFigure::columnCount(int panels) const {
  const int count = std::max(1, panels);
  const double least = options_.columns > 0 ? leastAsked : leastPicture;
  const int fitting =
      std::max(1, static_cast<int>((panelsWidth() + figureUnits(pictureGap)) / figureUnits(least + pictureGap)));
  const int most = options_.asRow ? std::max(count, options_.columns) : count;  // a row keeps its cells
  const int columns = std::min({options_.columns > 0 ? options_.columns : fitting, fitting, most});
  const int rows = (count + columns - 1) / columns;
  return options_.columns > 0 ? columns : (count + rows - 1) / rows;  // no row with a single panel beside full ones
}

double MotionVectorFigure::cellWidth(int columns) const {
  return (panelsWidth() - (columns - 1) * figureUnits(pictureGap)) / columns;
}

double MotionVectorFigure::headingHeight() const {
  double height = 0.0;
  for (const VectorPanelPainter& panel : panels_) height = std::max(height, panel.headingHeight(style_));
  return height;
}

VectorPanelPainter::Margins MotionVectorFigure::overhang(double faceScale) const {
  VectorPanelPainter::Margins all;
  for (const VectorPicture& picture : all_) {
    const VectorPanelPainter::Margins margins = VectorPanelPainter(picture, {}).overhang(style_, frame_, faceScale);
    all = {std::max(all.left, margins.left), std::max(all.top, margins.top), std::max(all.right, margins.right),
           std::max(all.bottom, margins.bottom)};
  }
  return all;
}

/// How large the face is drawn (figure units per mm) so that it and all arrows fit the cell.
double MotionVectorFigure::faceScaleWithin(const QSizeF& cell) {
  const Eigen::Vector2d size = frame_.sizes();
  double scale = std::min(cell.width() / size.x(), cell.height() / size.y());
  for (int i = 0; i < refinements; ++i) {
    if (options_.trueToFace) style_.scale = figureUnitsPerMillimetre / scale;
    const VectorPanelPainter::Margins margins = overhang(scale);
    const double width = std::max(cell.width() - margins.left - margins.right, 0.2 * cell.width());
    const double height = std::max(cell.height() - margins.top - margins.bottom, 0.2 * cell.height());
    scale = std::min(width / size.x(), height / size.y());
  }
  return scale;
}

void MotionVectorFigure::chooseReference() {
  if (style_.length == MotionVectorOptions::Length::Equal || !(longest_ > 0.0)) return;
  reference_ = roundBelow(std::min(longest_, style_.scale * referenceRoom * inner_ / figureUnitsPerMillimetre));
}

/// The width that the face takes of a cell whose height is given, without the key.
double MotionVectorFigure::drawnWidth(double cellWidth, double height) const {
  return options_.height > 0.0 ? std::min(cellWidth, height * frame_.sizes().x() / frame_.sizes().y()) : cellWidth;
}

void MotionVectorFigure::layOut() {
  const int columns = columnCount(static_cast<int>(panels_.size())),
            rows = (static_cast<int>(panels_.size()) + columns - 1) / columns;
  const double cellWidth = this->cellWidth(columns);
  const double words = words_->belowHeight() + (words_->belowHeight() > 0.0 ? figureUnits(wordsGap) : 0.0);
  const double top = figureUnits(FigureWords::border) + words_->titleHeight();
  const double between = std::max(0, rows - 1) * figureUnits(pictureRowGap) + rows * headingHeight();
  const auto freeAbove = [&](double below) {
    const double given = (figureUnits(options_.height) - top - below - between) / std::max(1, rows);
    return options_.height > 0.0 ? std::max(given, figureUnits(leastFace)) : mostShape * cellWidth;
  };
  double below = words + figureUnits(FigureWords::border);
  chooseScale((options_.asRow ? seriesRoom : arrowRoom) * drawnWidth(cellWidth, freeAbove(below)));
  chooseReference();
  if (std::any_of(all_.begin(), all_.end(), [](const VectorPicture& p) { return !p.arrows.empty(); })) addKey();
  const double gap = options_.keyBeside ? 0.0 : figureUnits(keyGap);
  below += gap + (key_ && !options_.keyBeside ? key_->height() : 0.0);
  const double panelHeight = placePanels(top, {cellWidth, freeAbove(below)}, columns);
  keyTop_ = top + rows * panelHeight + between + gap;
  size_.setHeight(std::ceil(std::max(keyTop_ - gap + below, figureUnits(options_.height))));
  wordsTop_ = size_.height() - figureUnits(FigureWords::border) - words_->belowHeight();
  if (key_) addKey();  // the scale may follow the size of the face
  if (key_ && options_.keyBeside) keyTop_ = top + std::max(0.0, 0.5 * (wordsTop_ - top - key_->height()));
}

void MotionVectorFigure::addKey() {
  key_.emplace(style_, reference_, options_.keyBeside ? inner_ - panelsWidth() - figureUnits(besideGap) : inner_,
               beyond_);
}

/// @return what a panel needs below its heading
double MotionVectorFigure::placePanels(double top, const QSizeF& free, int columns) {
  const double scale = faceScaleWithin(free);
  if (options_.trueToFace) chooseReference();
  const VectorPanelPainter::Margins margins = overhang(scale);
  const QSizeF plot = scale * QSizeF(frame_.sizes().x(), frame_.sizes().y());
  const double height = plot.height() + margins.top + margins.bottom;
  const double drawn = plot.width() + margins.left + margins.right;
  const double aside = 0.5 * (free.width() - drawn);
  keyLeft_ = figureUnits(FigureWords::border);
  if (options_.keyBeside) keyLeft_ += panelsWidth() - aside + figureUnits(besideGap);  // right behind the last face
  for (size_t i = 0; i < panels_.size(); ++i) {
    const double x = figureUnits(FigureWords::border) + (i % columns) * (free.width() + figureUnits(pictureGap));
    const double y = top + (i / columns) * (headingHeight() + height + figureUnits(pictureRowGap));
    headingPlaces_.emplace_back(x, y);
    panels_[i].place(QPointF(x + aside + margins.left, y + headingHeight() + margins.top), frame_, scale);
  }
  return height;
}

void MotionVectorFigure::paint(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  if (style_.theme.background.isValid()) painter.fillRect(QRectF(QPointF(), size_), style_.theme.background);
  words_->paintTitle(painter, style_.theme);
  for (size_t i = 0; i < panels_.size(); ++i) panels_[i].paint(painter, style_, headingPlaces_[i]);
  if (key_) key_->paint(painter, QPointF(keyLeft_, keyTop_));
  words_->paintBelow(painter, style_.theme, wordsTop_);
}

}  // namespace mien
