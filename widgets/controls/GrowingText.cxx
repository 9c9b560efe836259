#include "GrowingText.h"

#include <QHelpEvent>
#include <QTextBlock>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace mien {

GrowingText::GrowingText(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setTabChangesFocus(true);
  setLineWrapMode(QPlainTextEdit::WidgetWidth);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
  connect(this, &QPlainTextEdit::textChanged, this, &GrowingText::grow);
}

/// The size of such a document is counted in lines.
void GrowingText::grow() {
  const double lines = std::max(1.0, document()->size().height());
  const int around = 2 * frameWidth() + static_cast<int>(std::ceil(2.0 * document()->documentMargin()));
  setMinimumHeight(static_cast<int>(std::ceil(lines * fontMetrics().lineSpacing())) + around);
}

void GrowingText::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  grow();
}

void GrowingText::setDetails(const QStringList& details) {
  details_ = details;
}

bool GrowingText::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QPlainTextEdit::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString detail = details_.value(cursorForPosition(help->pos()).block().blockNumber());
  QToolTip::showText(help->globalPos(), detail.isEmpty() ? toolTip() : detail, this);
  return true;
}

/// Goes to what it lies in.
void GrowingText::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

}  // namespace mien
