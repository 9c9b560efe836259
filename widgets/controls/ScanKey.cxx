#include "ScanKey.h"

#include <QEvent>
#include <QPainter>

#include "Theme.h"

namespace mien {

namespace {

constexpr int keySwatch = 14, keyMargin = 8, keySpace = 6, keyBetween = 14, keyInset = 8;  // pixels
constexpr double keyCorner = 4.0;

}  // namespace

ScanKey::ScanKey(const QColor& scan, QWidget* view) : QWidget(view), scan_(scan) {
  setObjectName("scanKey");
  setAttribute(Qt::WA_TransparentForMouseEvents);  // what is dragged is the view
  setAccessibleName(tr("Blue is the scan, the colour of skin the face"));
  view->installEventFilter(this);
  place();
  hide();
}

QSize ScanKey::sizeHint() const {
  const int words = fontMetrics().horizontalAdvance(tr("Face")) + fontMetrics().horizontalAdvance(tr("Scan"));
  return {2 * keyMargin + 2 * (keySwatch + keySpace) + keyBetween + words, fontMetrics().height() + keyMargin};
}

void ScanKey::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::current();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme.line);
  painter.setBrush(theme.panel);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), keyCorner, keyCorner);
  painter.setRenderHint(QPainter::Antialiasing, false);
  int left = keyMargin;
  for (const auto& [name, color] : {std::pair(tr("Face"), theme.skin), std::pair(tr("Scan"), scan_)}) {
    painter.setBrush(color);
    painter.drawRect(left, (height() - keySwatch) / 2, keySwatch - 1, keySwatch - 1);
    left += keySwatch + keySpace;
    const int width = fontMetrics().horizontalAdvance(name);
    painter.setPen(theme.text);
    painter.drawText(QRect(left, 0, width, height()), Qt::AlignVCenter | Qt::AlignLeft, name);
    painter.setPen(theme.line);
    left += width + keyBetween;
  }
}

bool ScanKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QWidget::eventFilter(watched, event);
}

void ScanKey::place() {
  const QSize size = sizeHint();
  setGeometry(QRect(QPoint(keyInset, parentWidget()->height() - size.height() - keyInset), size));
}

}  // namespace mien
