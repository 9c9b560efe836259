#include "BarPanel.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "AxisScale.h"
#include "TextLines.h"

namespace {

using namespace mien;

constexpr double barRow = 4.2, axisRow = 8.0, gap = 1.5;  // mm
constexpr double wordsSize = 6.5;                         // pt

class BarDrawing {
 public:
  BarDrawing(const PeerGroup& group, QPainter& painter, const QRectF& place, const FigureTheme& theme)
      : group_(group), painter_(painter), theme_(theme), font_(figureFont(wordsSize)) {
    double words = 0.0, numbers = 0.0, least = 1e300, most = 0.0;
    for (const PeerTime& time : group.times) {
      words = std::max(words, textWidth(font_, QString::fromStdString(time.words)));
      numbers = std::max(numbers, textWidth(font_, numberOf(time)));
      least = std::min(least, time.milliseconds);
      most = std::max({most, time.milliseconds, time.target});
    }
    plot_ = place.adjusted(words + figureUnits(gap), 0.0, -numbers - figureUnits(gap), -figureUnits(axisRow));
    scale_ = AxisScale(std::pow(10.0, std::floor(std::log10(least / 1.2))), std::pow(10.0, std::ceil(std::log10(most))),
                       true);
  }

  void paint() {
    painter_.setFont(font_);
    paintAxis();
    for (size_t i = 0; i < group_.times.size(); ++i)
      paintBar(group_.times[i], plot_.top() + figureUnits(barRow) * static_cast<double>(i));
  }

 private:
  QString numberOf(const PeerTime& time) const {
    return QString::fromStdString(timeText(time.milliseconds) + " ms  " + ratioText(time.ratio));
  }

  double x(double value) const { return plot_.left() + plot_.width() * scale_.fraction(value); }

  void paintAxis() {
    const double below = plot_.bottom() + figureUnits(0.8) + 0.95 * font_.pixelSize();
    for (const AxisTick& tick : scale_.ticks({}, 6)) {
      if (tick.text.empty()) continue;
      painter_.setPen(QPen(theme_.grid, figureUnitsFromPoints(0.4)));
      painter_.drawLine(QPointF(x(tick.value), plot_.top()), QPointF(x(tick.value), plot_.bottom()));
      paintText(QString::fromStdString(tick.text), x(tick.value), below, 0.5);
    }
    paintText(QStringLiteral("median time (ms)"), plot_.center().x(), below + lineHeight(font_), 0.5);
  }

  void paintBar(const PeerTime& time, double top) {
    const double height = figureUnits(0.6 * barRow), y = top + figureUnits(0.2 * barRow);
    const double baseline = y + 0.5 * height + 0.36 * font_.pixelSize();
    painter_.fillRect(QRectF(QPointF(plot_.left(), y), QPointF(x(time.milliseconds), y + height)),
                      theme_.series[time.own ? 0 : 4]);
    if (time.target > 0.0) {
      painter_.setPen(QPen(theme_.text, figureUnitsFromPoints(1.2)));
      const double reach = figureUnits(0.1 * barRow);
      painter_.drawLine(QPointF(x(time.target), y - reach), QPointF(x(time.target), y + height + reach));
    }
    paintText(QString::fromStdString(time.words), plot_.left() - figureUnits(gap), baseline, 1.0);
    paintText(numberOf(time), plot_.right() + figureUnits(gap), baseline, 0.0);
  }

  /// @param share  of the text left of x
  void paintText(const QString& text, double x, double baseline, double share) {
    painter_.setPen(theme_.text);
    painter_.drawText(QPointF(x - share * textWidth(font_, text), baseline), text);
  }

  const PeerGroup& group_;
  QPainter& painter_;
  const FigureTheme& theme_;
  QFont font_;
  QRectF plot_;
  AxisScale scale_;
};

}  // namespace

std::string timeText(double milliseconds) {
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(milliseconds))), 0, 6);
  return QString::number(milliseconds, 'f', decimals).toStdString();
}

std::string ratioText(double ratio) {
  return ratio > 0.0 ? "× " + timeText(ratio) : "";
}

mien::PlatePanel barPanel(const PeerGroup& group, double width) {
  const double height = barRow * static_cast<double>(group.times.size()) + axisRow;
  std::string heading = group.heading;
  if (!group.reference.empty()) heading += "; × times " + group.reference;
  const auto paint = [group](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    BarDrawing(group, painter, place, theme).paint();
  };
  return {heading, 1, height / width, paint};
}
