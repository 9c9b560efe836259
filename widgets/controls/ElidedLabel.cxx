#include "ElidedLabel.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <QVariant>

#include "Theme.h"

namespace mien {

ElidedLabel::ElidedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
}

QString ElidedLabel::shownText() const {
  return fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
}

QSize ElidedLabel::minimumSizeHint() const {
  return {1, QLabel::minimumSizeHint().height()};
}

bool ElidedLabel::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || shownText() == text()) return QLabel::event(event);
  const QString whole = toolTip().isEmpty() ? text() : text() + "\n\n" + toolTip();
  QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), whole, this);
  return true;
}

/// A text that fits is drawn by the label itself, which lets the mouse select it. Colours are those of the style sheet,
/// which a label's palette does not know.
void ElidedLabel::paintEvent(QPaintEvent* event) {
  const QString shown = shownText();
  if (shown == text()) return QLabel::paintEvent(event);
  QPainter painter(this);
  painter.setPen(property("faint").toBool() ? Theme::current().faintText : Theme::current().text);
  painter.drawText(contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, shown);
}

}  // namespace mien
