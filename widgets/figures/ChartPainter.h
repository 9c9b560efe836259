#pragma once

#include <QPolygonF>
#include <QRectF>
#include <QString>

#include "AxisScale.h"
#include "Chart.h"
#include "FigureTheme.h"

class QPainter;

namespace mien {

/// Draws one chart into a cell of a figure: titles and numbers at the edges, the plot in what is left.
///
/// Layout goes in two steps, so that the plots of a figure can share margins: ask for the margins, then place.
class ChartPainter {
 public:
  struct Margins {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  };

  /// `label` stands before the title: "(a)".
  ChartPainter(const Chart& chart, const FigureTheme& theme, const QString& label);

  /// What the text around a plot of that height needs in a cell of that width, in figure units.
  Margins margins(double cellWidth, double plotHeight) const;

  void place(const QRectF& cell, const Margins& margins);
  void paint(QPainter& painter) const;

  /// The rectangle between the axes, once placed.
  const QRectF& plot() const { return plot_; }
  const AxisScale& xScale() const { return x_; }
  const AxisScale& yScale() const { return y_; }

  /// Where a pair of values lies in the figure.
  QPointF position(double x, double y) const;

  /// The style number of a series.
  static int styleOf(const Chart& chart, size_t series);

 private:
  QString heading() const;
  QStringList xTitleLines(double cellWidth) const;
  std::vector<AxisTick> xTicks(double plotWidth) const;
  std::vector<AxisTick> yTicks(double plotHeight) const;
  bool namesFit(double plotWidth, size_t step) const;
  bool namesStandUpright(double plotWidth) const;
  std::vector<AxisTick> nameTicks(double plotWidth) const;
  double categoryWidth() const;
  double numberDepth(double plotWidth) const;
  double overhang(double plotWidth) const;
  void paintHeading(QPainter& painter) const;
  void paintXAxis(QPainter& painter) const;
  void paintCategory(QPainter& painter, double x, const QString& text) const;
  void paintYAxis(QPainter& painter) const;
  void paintFrame(QPainter& painter) const;
  void paintMarks(QPainter& painter) const;
  void paintBars(QPainter& painter, size_t series) const;
  void paintLine(QPainter& painter, size_t series) const;
  void paintMarkers(QPainter& painter, size_t series) const;
  std::vector<QPolygonF> unbrokenLines(const ChartSeries& series) const;

  Chart chart_;
  FigureTheme theme_;
  QString label_;
  AxisScale x_, y_;
  QRectF cell_, plot_;
};

}  // namespace mien
