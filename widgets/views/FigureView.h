#pragma once

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <optional>

#include "FigurePainter.h"

namespace mien {

/// A figure on the screen, as large as its widget, with a marker at one x that mouse and keyboard move.
class FigureView : public QWidget {
  Q_OBJECT
 public:
  enum class Marker {
    Line,  ///< through a value, with a handle to drag
    Band   ///< around a category
  };

  FigureView(const QString& objectName, Marker marker, QWidget* parent = nullptr);
  ~FigureView() override;

  void setFigure(const Figure& figure);
  const Figure& figure() const { return figure_; }

  /// What stands in place of a figure without panels.
  void setHint(const QString& hint);

  /// Where the marker stands, in the panels' x; nothing: no marker.
  void setMarked(std::optional<double> x);
  std::optional<double> marked() const { return marked_; }
  void setMarkerName(const QString& name);  ///< beside a line, in words; empty: none

  /// The part of the panels' x that counts: all else is veiled; nothing: all counts.
  void setBand(std::optional<std::pair<double, double>> band);
  std::optional<std::pair<double, double>> band() const { return band_; }

  /// Where a pair of values of a panel lies, in pixels.
  QPointF pixelOf(int panel, double x, double y) const;

  QSize sizeHint() const override { return {420, 220}; }
  QSize minimumSizeHint() const override { return {220, 130}; }

 signals:
  void picked(double x);                     ///< pressed or dragged to with the left button
  void zoomed(double x, double factor);      ///< by the wheel, with x under the pointer; above 1: more is seen
  void bandDragged(double from, double to);  ///< with Shift and the left button
  void stepped(int steps);                   ///< by the arrow keys; Page up and down go by 5, Home and End by 1000

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void layOut();
  double valueUnder(const QPointF& pixel) const;
  void pickAt(const QPointF& pixel);
  void paintFigure(QPainter& painter);
  void paintBand(QPainter& painter, const ChartPainter& panel) const;
  void paintMarker(QPainter& painter, const ChartPainter& panel) const;
  void paintMarkerName(QPainter& painter, const ChartPainter& panel, const QPointF& beside) const;
  int linesIn(const ChartPainter& panel, const QRectF& place) const;

  Figure figure_;
  Marker marker_;
  QString hint_, markerName_;
  std::unique_ptr<FigurePainter> painter_;
  QPixmap picture_;  ///< of the figure, which is slow to draw: a marker that moves is not
  std::optional<double> marked_, bandStart_;
  std::optional<std::pair<double, double>> band_;
};

}  // namespace mien
