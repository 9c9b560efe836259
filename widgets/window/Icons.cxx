#include "Icons.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

namespace mien {

namespace {

/// Shapes on a square of 16 units.
QPainterPath filledShape(Symbol symbol) {
  QPainterPath path;
  if (symbol == Symbol::Play) {
    path.addPolygon(QPolygonF({{4, 2.5}, {13.5, 8}, {4, 13.5}}));
  } else if (symbol == Symbol::Pause) {
    path.addRect(3.5, 3, 3, 10);
    path.addRect(9.5, 3, 3, 10);
  } else if (symbol == Symbol::First) {
    path.addRect(3, 3, 2, 10);
    path.addPolygon(QPolygonF({{13, 3}, {6, 8}, {13, 13}}));
  } else if (symbol == Symbol::Reset) {
    path.addPolygon(QPolygonF({{2.2, 2.2}, {2.2, 7.2}, {7.2, 7.2}}));
  } else if (symbol == Symbol::Loop) {
    path.addPolygon(QPolygonF({{9.5, 0.8}, {13.2, 4}, {9.5, 7.2}}));
  }
  return path;
}

QPainterPath lineShape(Symbol symbol) {
  QPainterPath path;
  if (symbol == Symbol::Reset) {
    path.arcMoveTo(3, 3, 10, 10, 150);
    path.arcTo(3, 3, 10, 10, 150, -300);
  } else if (symbol == Symbol::Loop) {
    path.moveTo(10, 4);
    path.lineTo(6, 4);
    path.arcTo(2, 4, 8, 8, 90, 180);
    path.lineTo(10, 12);
    path.arcTo(6, 4, 8, 8, 270, 90);
  } else if (symbol == Symbol::Close) {
    path.moveTo(4, 4);
    path.lineTo(12, 12);
    path.moveTo(12, 4);
    path.lineTo(4, 12);
  } else if (symbol == Symbol::Detach) {
    path.addRoundedRect(2.5, 5.5, 8, 8, 1, 1);
    path.moveTo(6, 5);
    path.addPolygon(QPolygonF({{6, 5}, {6, 2.5}, {13.5, 2.5}, {13.5, 10}, {11, 10}}));
  } else if (symbol == Symbol::Open) {
    path.addPolygon(QPolygonF({{2, 13}, {2, 4}, {6, 4}, {7.5, 5.5}, {13, 5.5}, {13, 7.5}}));
    path.moveTo(2, 13);
    path.addPolygon(QPolygonF({{2, 13}, {4.5, 7.5}, {15, 7.5}, {12.5, 13}, {2, 13}}));
  }
  return path;
}

class SymbolEngine : public QIconEngine {
 public:
  explicit SymbolEngine(Symbol symbol) : symbol_(symbol) {}

  /// A pressed button is tinted, not filled: its icon keeps the colour of text.
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const QColor color = QApplication::palette().color(group, QPalette::ButtonText);
    const double scale = qMin(rect.width(), rect.height()) / 16.0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(scale, scale);
    painter->fillPath(filledShape(symbol_), color);
    painter->strokePath(lineShape(symbol_), QPen(color, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap image(size);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return image;
  }

  QIconEngine* clone() const override { return new SymbolEngine(symbol_); }

 private:
  Symbol symbol_;
};

}  // namespace

QIcon icon(Symbol symbol) {
  return QIcon(new SymbolEngine(symbol));
}

}  // namespace mien
