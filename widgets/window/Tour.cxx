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
constexpr int mostTourWidth = 330, padding = 14, tourGap = 10, radius = 7;  // pixels
constexpr int titleGap = 4;
constexpr int veil = 150;  // of 255, over what is not spoken of

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
  add("faceView", tr("The face"),
      tr("Nine PDE patches. Drag to turn, wheel to zoom, double click for the whole face. Above it: what its colours "
         "mean, and a second face to compare with."));
  add("curveView", tr("Its 29 boundary curves"),
      tr("All that the surface is made of. Colour says how far they have moved, in mm."));
  add("timelinePanel", tr("Animations"),
      tr("Open a .fap file or drop one on the window; File > Play the demonstration has one to begin with."));
  add("workspaces", tr("Workspaces"),
      tr("Animate, Surface, Deform, Acquire: each opens the docks for its work. F1 explains the one you are in."));
  setGeometry(window.rect());
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

int Tour::textHeight(const Stop& stop, int width) const {
  const QRect room(0, 0, width, height());
  return QFontMetrics(titleFont(font())).boundingRect(room, Qt::TextWordWrap, stop.title).height() + titleGap +
         fontMetrics().boundingRect(room, Qt::TextWordWrap, stop.text).height();
}

/// In the middle of its part of the window, at the foot of a dock, so that its first controls are seen; below one that
/// is too low to hold it, unless that lies at the window's foot.
QRect Tour::calloutOf(int stop) const {
  const QRect target = targetOf(stop);
  if (target.isEmpty()) return {};
  const bool isLow = target.height() < textHeight(stops_[stop], mostTourWidth) + 2 * padding;
  const int width = isLow ? mostTourWidth : std::min(mostTourWidth, target.width() - 2 * tourGap - 2 * padding);
  QRect box(0, 0, width + 2 * padding, textHeight(stops_[stop], width) + 2 * padding);
  box.moveCenter(target.center());
  if (qobject_cast<const QDockWidget*>(stops_[stop].target)) box.moveBottom(target.bottom() - tourGap);
  if (isLow) box.moveTop(target.bottom() + tourGap);
  if (box.bottom() > height() - tourGap) box.moveBottom(target.top() - tourGap);
  box.moveLeft(std::clamp(box.left(), tourGap, std::max(tourGap, this->width() - tourGap - box.width())));
  return box;
}

void Tour::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), QColor(0, 0, 0, veil));
  for (int stop = 0; stop < stopCount(); ++stop) paintStop(painter, stop);
  paintHint(painter);
}

void Tour::paintStop(QPainter& painter, int stop) const {
  const QRect target = targetOf(stop), box = calloutOf(stop);
  if (target.isEmpty()) return;
  const Theme& theme = Theme::current();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.accent, 2.0));
  painter.drawRoundedRect(QRectF(target).adjusted(2, 2, -2, -2), radius, radius);
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
}

void Tour::paintHint(QPainter& painter) const {
  const QString text = tr("A click or Esc begins. Help > Tour shows this again.");
  QRect box(0, 0, fontMetrics().horizontalAdvance(text) + 2 * padding, fontMetrics().height() + padding);
  box.moveCenter(QPoint(width() / 2, 0));
  box.moveTop(tourGap);
  painter.setPen(Qt::NoPen);
  painter.setBrush(Theme::current().accent);
  painter.drawRoundedRect(box, box.height() / 2.0, box.height() / 2.0);
  painter.setPen(Theme::current().accentText);
  painter.drawText(box, Qt::AlignCenter, text);
}

void Tour::mousePressEvent(QMouseEvent*) {
  close();
}

void Tour::keyPressEvent(QKeyEvent*) {
  close();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::Resize) setGeometry(window_.rect());
  return QWidget::eventFilter(watched, event);
}

}  // namespace mien
