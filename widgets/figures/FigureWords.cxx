#include "FigureWords.h"

#include <QPainter>

#include "TextLines.h"

namespace mien {

namespace {

constexpr double titleSize = 8.5, captionSize = 7.0, noteSize = 6.0;  // pt
constexpr double titleGap = 0.8;                                      // mm

}  // namespace

double FigureWords::Paragraph::height() const {
  return lines.size() * lineHeight(font);
}

double FigureWords::Paragraph::paint(QPainter& painter, const FigureTheme& theme, double y) const {
  painter.setFont(font);
  painter.setPen(theme.text);
  for (const QString& line : lines) {
    painter.drawText(QPointF(figureUnits(border), y + 0.95 * font.pixelSize()), line);
    y += lineHeight(font);
  }
  return y;
}

FigureWords::FigureWords(const std::string& title, const std::string& caption, const std::string& note, double width,
                         const QString& family) {
  const auto broken = [&](QFont font, const std::string& text) {
    if (!family.isEmpty()) font.setFamily(family);
    return Paragraph{font, textLines(font, QString::fromStdString(text), figureUnits(width - 2.0 * border))};
  };
  title_ = broken(figureFont(titleSize, true), title);
  caption_ = broken(figureFont(captionSize), caption);
  note_ = broken(figureFont(noteSize), note);
}

double FigureWords::titleHeight() const {
  return title_.lines.isEmpty() ? 0.0 : title_.height() + figureUnits(titleGap);
}

double FigureWords::belowHeight() const {
  return caption_.height() + note_.height();
}

void FigureWords::paintTitle(QPainter& painter, const FigureTheme& theme) const {
  title_.paint(painter, theme, figureUnits(border));
}

void FigureWords::paintBelow(QPainter& painter, const FigureTheme& theme, double y) const {
  note_.paint(painter, theme, caption_.paint(painter, theme, y));
}

}  // namespace mien
