#include "Tour.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTimer>
#include <algorithm>

#include "Remembered.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr const char* seenKey = "window/tourSeen";
constexpr int tourWidths[] = {330, 280, 230};  // pixels of a text, the first for which there is room
constexpr int padding = 14, tourGap = 10, radius = 7, ring = 3, edge = 2;  // pixels
constexpr int barShape = 3;                                                // wider than that many times its height
constexpr int titleGap = 4, hintGap = 8;                                   // pixels
constexpr int veil = 150;                                                  // of 255, over what is not spoken of

QFont titleFont(QFont font) {
  font.setBold(true);
  return font;
}

}  // namespace

Tour* Tour::begin(QMainWindow& window) {
  auto* tour = new Tour(window);
  tour->setAttribute(Qt::WA_DeleteOnClose);
  tour->show();
  tour->raise();
  tour->setFocus();
  return tour;
}

void Tour::showAtFirstStart(QMainWindow& window) {
  const auto* offer = window.findChild<QWidget*>("recoveryBar");
  if (offer && !offer->isHidden()) return;  // which comes first, and the tour at the next start
  if (Remembered::value(seenKey, false).toBool()) return;
  Remembered::set(seenKey, true);
  if (Remembered::value(seenKey, false).toBool())
    QTimer::singleShot(0, &window, [&window] { begin(window); });  // once all has its place
}

Tour::Tour(QMainWindow& window) : QWidget(&window), window_(window) {
  setObjectName("tour");
  setFocusPolicy(Qt::StrongFocus);
  add("expressionDock", tr("Expressions and visemes"),
      tr("A click shows one expression, sliders mix several (percent)."));
  add("fapDock", tr("Facial animation parameters"),
      tr("Each slider moves one part of the face, in FAP units and mm. Mirror lock keeps both sides alike."));
  add("faceFrame", tr("The face"),
      tr("Nine PDE patches. Drag to turn, wheel to zoom, double click for the whole face. Above it: what its colours "
         "mean, and a second face to compare with."));
  add("curveFrame", tr("Its 29 boundary curves"),
      tr("All that the surface is made of. Colour says how far they have moved, in mm."));
  add("timelinePanel", tr("Animations"),
      tr("Open a .fap file or drop one on the window, or begin with the demonstration."));
  add("workspaces", tr("Workspaces"),
      tr("Animate, Surface, Deform, Acquire: each opens the docks for its work. F1 explains them."));
  setGeometry(window.rect());
  current_ = -1;
  step(1);
  window.installEventFilter(this);
}

void Tour::add(const QString& name, const QString& title, const QString& text) {
  auto* target = window_.findChild<QWidget*>(name);
  if (target) stops_.push_back({target, title, text});
}

QRect Tour::targetOf(int stop) const {
  const QWidget* target = stops_[stop].target;
  if (!target || !target->isVisible()) return {};
  return QRect(target->mapTo(&window_, QPoint()), target->size());
}

void Tour::step(int by) {
  int next = current_ + by;
  while (next >= 0 && next < stopCount() && targetOf(next).isEmpty()) next += by;
  if (next >= stopCount()) {
    close();
    return;
  }
  current_ = std::max(0, next);
  update();
}

QString Tour::hint(int stop) const {
  const QString place = tr("%1 of %2").arg(stop + 1).arg(stopCount());
  return stop + 1 < stopCount() ? tr("%1 \u00b7 click or Space: next \u00b7 Esc: end").arg(place)
                                : tr("%1 \u00b7 Help > Tour shows this again").arg(place);
}

QSize Tour::sizeOfText(int stop, int width) const {
  const QRect room(0, 0, width, height());
  const int title = QFontMetrics(titleFont(font())).boundingRect(room, Qt::TextWordWrap, stops_[stop].title).height();
  const int text = fontMetrics().boundingRect(room, Qt::TextWordWrap, stops_[stop].text).height();
  const int foot = fontMetrics().boundingRect(room, Qt::TextWordWrap, hint(stop)).height();
  return {width + 2 * padding, title + titleGap + text + hintGap + foot + 2 * padding};
}

/// At the right, at the left, below and above, each within the window; of a bar below and above first.
std::vector<QRect> Tour::placesBeside(const QRect& target, const QSize& size) const {
  std::vector<QRect> places(4, QRect(QPoint(), size));
  for (QRect& place : places) place.moveCenter(target.center());
  places[0].moveLeft(target.right() + tourGap);
  places[1].moveRight(target.left() - tourGap);
  places[2].moveTop(target.bottom() + tourGap);
  places[3].moveBottom(target.top() - tourGap);
  for (QRect& place : places) {
    place.moveLeft(std::clamp(place.left(), tourGap, std::max(tourGap, width() - tourGap - place.width())));
    place.moveTop(std::clamp(place.top(), tourGap, std::max(tourGap, height() - tourGap - place.height())));
  }
  if (target.width() > barShape * target.height()) std::rotate(places.begin(), places.begin() + 2, places.end());
  return places;
}

/// Beside its part of the window; where there is no room at any side, narrower.
QRect Tour::calloutOf(int stop) const {
  const QRect target = targetOf(stop);
  if (target.isEmpty()) return {};
  for (int width : tourWidths)
    for (const QRect& place : placesBeside(target, sizeOfText(stop, width)))
      if (!place.intersects(target)) return place;
  return placesBeside(target, sizeOfText(stop, tourWidths[0])).back();
}

void Tour::paintEvent(QPaintEvent*) {
  const QRect target =
      targetOf(current_).adjusted(-ring, -ring, ring, ring) & rect().adjusted(edge, edge, -edge, -edge);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath around, hole;
  around.addRect(rect());
  hole.addRoundedRect(target, radius, radius);
  painter.fillPath(around.subtracted(hole), QColor(0, 0, 0, veil));
  painter.setPen(QPen(Theme::current().accent, ring));
  painter.drawPath(hole);
  paintText(painter, current_);
}

void Tour::paintText(QPainter& painter, int stop) const {
  const QRect box = calloutOf(stop);
  if (box.isEmpty()) return;
  const Theme& theme = Theme::current();
  painter.setPen(QPen(theme.accent, 1.0));
  painter.setBrush(theme.panel);
  painter.drawRoundedRect(QRectF(box).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
  QRect text = box.adjusted(padding, padding, -padding, -padding), used;
  painter.setPen(theme.text);
  painter.setFont(titleFont(font()));
  painter.drawText(text, Qt::TextWordWrap, stops_[stop].title, &used);
  painter.setFont(font());
  text.setTop(used.bottom() + titleGap);
  painter.drawText(text, Qt::TextWordWrap, stops_[stop].text);
  painter.setPen(theme.faintText);
  painter.drawText(text, Qt::TextWordWrap | Qt::AlignBottom, hint(stop));
}

void Tour::mousePressEvent(QMouseEvent*) {
  step(1);
}

void Tour::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    close();
    return;
  }
  const bool isBack = event->key() == Qt::Key_Left || event->key() == Qt::Key_Backspace;
  step(isBack ? -1 : 1);
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::Resize) setGeometry(window_.rect());
  return QWidget::eventFilter(watched, event);
}

}  // namespace mien
