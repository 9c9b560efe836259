#include "TextLines.h"

#include <QFontMetricsF>

namespace mien {

double textWidth(const QFont& font, const QString& text) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

double lineHeight(const QFont& font) {
  return 1.25 * font.pixelSize();
}

QStringList textLines(const QFont& font, const QString& text, double width) {
  QStringList lines;
  for (const QString& paragraph : text.split('\n')) {
    QString line;
    for (const QString& word : paragraph.split(' ', Qt::SkipEmptyParts)) {
      const QString longer = line.isEmpty() ? word : line + ' ' + word;
      if (!line.isEmpty() && textWidth(font, longer) > width) {
        lines << line;
        line = word;
      } else {
        line = longer;
      }
    }
    if (!line.isEmpty()) lines << line;
  }
  return lines;
}

}  // namespace mien
