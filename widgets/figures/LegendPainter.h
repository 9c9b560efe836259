#pragma once

#include <QPointF>

#include "Figure.h"
#include "FigureTheme.h"

class QPainter;

namespace mien {

/// The names of a figure's series, marks and breakdowns, each once, in rows that fit the figure's width.
class LegendPainter {
 public:
  LegendPainter(const Figure& figure, const FigureTheme& theme, double width);

  double height() const;
  void paint(QPainter& painter, const QPointF& topLeft) const;

 private:
  struct Entry {
    enum class Kind { Line, Bar, Mark, Breakdown, OffScale };
    Kind kind;
    QString name;
    int style;
    QPointF place;  ///< of the symbol's left end, from the legend's top left
  };

  void collect(const Figure& figure);
  void add(Entry::Kind kind, const std::string& name, int style);
  void place(double width);
  void paintSymbol(QPainter& painter, const Entry& entry, const QPointF& left) const;

  FigureTheme theme_;
  std::vector<Entry> entries_;
  int rows_ = 0;
};

}  // namespace mien
