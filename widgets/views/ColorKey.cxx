#include "ColorKey.h"

#include <QLinearGradient>
#include <QPainter>
#include <algorithm>
#include <utility>

#include "FaceLayout.h"
#include "FootBand.h"
#include "PatchColors.h"
#include "RealMinus.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int keySide = 12, keyGap = 12, keyBarHeight = 9, keyAbove = 6, keyTick = 3, keyBelow = 4;  // pixels
constexpr int leastBar = 80, swatch = 14, swatchGap = 5;
constexpr int stops = 32;
constexpr int pointed = 8;  // pixels, length of an end beyond which there are values

QString patchText(int patch) {
  const int first = FaceLayout::firstCurve[patch], last = first + FaceLayout::curvesPerPatch - 1;
  return ColorKey::tr("P%1: %2 to %3")
      .arg(patch)
      .arg(QString::fromStdString(FaceLayout::curveName(first)), QString::fromStdString(FaceLayout::curveName(last)));
}

QString keyNumber(double value) {
  return withRealMinus(QString::number(value, 'g', 3));
}

QColor over(const QColor& below, const QColor& translucent) {
  const auto mixed = [&](double back, double front) { return back + translucent.alphaF() * (front - back); };
  return QColor::fromRgbF(mixed(below.redF(), translucent.redF()), mixed(below.greenF(), translucent.greenF()),
                          mixed(below.blueF(), translucent.blueF()));
}

/// The unit stays, whatever else has no room.
QString shortened(const QString& title, const QFontMetrics& metrics, int most) {
  const int unit = title.lastIndexOf(" (");
  if (metrics.horizontalAdvance(title) <= most || unit < 0) return metrics.elidedText(title, Qt::ElideRight, most);
  const QString end = title.mid(unit);
  return metrics.elidedText(title.left(unit), Qt::ElideRight, std::max(0, most - metrics.horizontalAdvance(end))) + end;
}

}  // namespace

ColorKey::ColorKey(QWidget* parent) : QWidget(parent) {
  setObjectName("colorKey");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  hide();
}

QSize ColorKey::sizeHint() const {
  return {300, keyAbove + keyBarHeight + keyTick + keyBelow + fontMetrics().height()};
}

QSize ColorKey::minimumSizeHint() const {
  return {120, sizeHint().height()};
}

void ColorKey::showScale(const ColorLegend::Scale& scale) {
  shown_ = Shown::Scale;
  scale_ = scale;
  setToolTip(tr("%1: what lies beyond an end of the scale has the colour of that end; there are such values where the "
                "end is pointed")
                 .arg(scale.title) +
             (scale.unknown.isEmpty() ? QString() : tr("; grey: %1").arg(scale.unknown)));
  show();
  update();
}

void ColorKey::showPatches() {
  shown_ = Shown::Patches;
  QStringList patches;
  for (int i = 0; i < FaceLayout::patchCount; ++i) patches << patchText(i);
  setToolTip(tr("The nine patches and the curves that bound them\n") + patches.join('\n'));
  show();
  update();
}

void ColorKey::showScan(const QColor& scan) {
  shown_ = Shown::Skins;
  scan_ = scan;
  setToolTip(tr("The face in the colour of its skin, and the scan, which is translucent, over it"));
  show();
  update();
}

void ColorKey::showWords(const QString& words) {
  shown_ = Shown::Words;
  words_ = words;
  setToolTip(words);
  show();
  update();
}

void ColorKey::clear() {
  shown_ = Shown::Nothing;
  hide();
}

/// Below the title. @return how wide it is, in pixels
int ColorKey::paintUnknown(QPainter& painter, int most) const {
  if (scale_.unknown.isEmpty()) return 0;
  const QFontMetrics metrics = fontMetrics();
  const int before = swatch + swatchGap;
  const QString text = metrics.elidedText(scale_.unknown, Qt::ElideRight, std::max(0, most - before));
  const double low = keyAbove + keyBarHeight + keyTick + metrics.ascent();
  painter.setPen(QPen(Theme::current().line, 1.0));
  painter.setBrush(ColorLegend::unknownColor());
  painter.drawRect(QRectF(keySide, low - keyBarHeight, swatch, keyBarHeight));
  painter.setPen(Theme::current().text);
  painter.drawText(QPointF(keySide + before, low), text);
  return before + metrics.horizontalAdvance(text);
}

/// Of a number that stands under an end of the bar.
int ColorKey::halfWidth(double number) const {
  return fontMetrics().horizontalAdvance(keyNumber(number)) / 2;
}

/// Beside the bar.
int ColorKey::roomForWords() const {
  return std::max(0, width() - 2 * keySide - keyGap - leastBar - behindBar());
}

int ColorKey::behindBar() const {
  return std::max<int>(halfWidth(scale_.end), pointed);
}

/// Beside the bar alone, whose numbers stand lower.
QString ColorKey::shownTitle() const {
  return shortened(scale_.title, fontMetrics(), roomForWords() - (scale_.undercut ? pointed : 0));
}

void ColorKey::paintScale(QPainter& painter) const {
  const Theme& theme = Theme::current();
  const QFontMetrics metrics = fontMetrics();
  const QString title = shownTitle();
  const int titleWidth = metrics.horizontalAdvance(title) + (scale_.undercut ? pointed : 0);
  const int before = halfWidth(scale_.begin), behind = behindBar();
  const int words = std::max(titleWidth, paintUnknown(painter, roomForWords() - before) + before);
  const int left = keySide + words + keyGap;
  const QRectF bar(left, keyAbove, std::max(leastBar, width() - keySide - behind - left), keyBarHeight);
  QLinearGradient colors(bar.topLeft(), bar.topRight());
  for (int i = 0; i <= stops; ++i)
    colors.setColorAt(i / double(stops), ColorLegend::colorAt(scale_.colors, i / double(stops)));
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(colors);
  QPolygonF shape;
  shape << bar.topLeft() << bar.topRight();
  if (scale_.exceeded) shape << QPointF(bar.right() + pointed, bar.center().y());
  shape << bar.bottomRight() << bar.bottomLeft();
  if (scale_.undercut) shape << QPointF(bar.left() - pointed, bar.center().y());
  painter.drawPolygon(shape);
  painter.setPen(theme.text);
  painter.drawText(QPointF(keySide, keyAbove + keyBarHeight / 2.0 + metrics.ascent() / 2.0 - 1.0), title);
  for (double share : {0.0, 0.5, 1.0}) {
    const double x = bar.left() + share * bar.width();
    const QString text = keyNumber(scale_.begin + share * (scale_.end - scale_.begin));
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + keyTick));
    painter.drawText(QPointF(x - metrics.horizontalAdvance(text) / 2.0, bar.bottom() + keyTick + metrics.ascent()),
                     text);
  }
}

void ColorKey::paintPatches(QPainter& painter) const {
  const double step = (width() - 2.0 * keySide) / FaceLayout::patchCount;
  for (int i = 0; i < FaceLayout::patchCount; ++i)
    paintSwatch(painter, keySide + i * step, QColor(static_cast<QRgb>(patchColors[i])), tr("P%1").arg(i), step);
}

/// The background and the face show through the scan here as they do in the view.
void ColorKey::paintSkins(QPainter& painter) const {
  const QColor& skin = Theme::current().skin;
  const std::pair<QColor, QString> skins[] = {
      {skin, tr("Face")}, {scan_, tr("Scan")}, {over(skin, scan_), tr("Scan on face")}};
  double left = keySide;
  for (const auto& [color, text] : skins) {
    const int room = std::max(0, static_cast<int>(width() - keySide - left - swatch - swatchGap));
    paintSwatch(painter, left, color, fontMetrics().elidedText(text, Qt::ElideRight, room));
    left += 2 * swatch + fontMetrics().horizontalAdvance(text) + keyGap;
  }
}

/// Where there is little room the swatch is narrow.
void ColorKey::paintSwatch(QPainter& painter, double left, const QColor& color, const QString& text,
                           double room) const {
  const double gap = std::min<double>(swatchGap, 0.1 * room);
  const double wide = std::clamp(room - fontMetrics().horizontalAdvance(text) - 2.0 * gap, 0.4 * swatch, 1.0 * swatch);
  const QRectF place(left, 0.5 * (height() - swatch), wide, swatch);
  painter.fillRect(place, Theme::current().viewBottom);
  painter.setPen(QPen(Theme::current().line, 1.0));
  painter.setBrush(color);
  painter.drawRect(place);
  painter.setPen(Theme::current().text);
  painter.drawText(QPointF(place.right() + gap, 0.5 * (height() + fontMetrics().ascent()) - 1.0), text);
}

void ColorKey::paintWords(QPainter& painter) const {
  painter.setPen(Theme::current().faintText);
  const QRect place = rect().adjusted(keySide, 0, -keySide, 0);
  painter.drawText(place, Qt::AlignVCenter, fontMetrics().elidedText(words_, Qt::ElideRight, place.width()));
}

void ColorKey::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paintFoot(painter, rect());
  if (shown_ == Shown::Words) paintWords(painter);
  if (shown_ == Shown::Patches) paintPatches(painter);
  if (shown_ == Shown::Skins) paintSkins(painter);
  painter.translate(0.0, (height() - sizeHint().height()) / 2);
  if (shown_ == Shown::Scale) paintScale(painter);
}

}  // namespace mien
