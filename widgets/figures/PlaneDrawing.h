#pragma once

#include <QColor>
#include <QPolygonF>
#include <QString>
#include <vector>

namespace mien {

/// How the strokes of a drawing look. Colours left invalid are the theme's text colour; series colours of the light
/// theme become those of the theme that draws (FigureTheme::own).
struct PlaneStroke {
  QColor color = {};
  double width = 0.6;  ///< pt; 0: none
  bool dashed = false;
  QColor fill = {};  ///< invalid: not filled
};

/// A drawing in a plane, x to the right and y up, in mm of the face or any other one unit.
struct PlaneDrawing {
  struct Line {
    QPolygonF points;
    PlaneStroke stroke;
    bool closed = false;
    bool arrow = false;  ///< with a head at its last point
  };
  struct Mark {
    QPointF at;
    double radius = 1.6;  ///< pt, whatever the drawing's scale
    PlaneStroke stroke;
  };
  struct Label {
    QPointF at;
    QString text;
    double size = 6.0;     ///< pt
    int alignment = 0x84;  ///< Qt::Alignment of the text to its point: Qt::AlignCenter; AlignLeft stands right of it
    QColor color = {};
    bool bold = false;
    bool halo = false;  ///< of the theme's background, so that lines end before the text
  };

  std::vector<Line> lines;
  std::vector<Mark> marks;
  std::vector<Label> labels;

  QRectF bounds() const;  ///< of lines and marks, y up
};

inline QPolygonF segment(const QPointF& from, const QPointF& to) {
  QPolygonF line;
  line << from << to;
  return line;
}

}  // namespace mien
