#pragma once

#include <QSizeF>

#include "FigureWords.h"
#include "Plate.h"

namespace mien {

/// Lays a plate out and paints it. Panels of one row share its height; everything is in hundredths of a millimetre, and
/// type keeps its size whatever the plate's width. Needs a FigureApplication, for its fonts.
class PlatePainter {
 public:
  /// @param width    of the figure, mm
  /// @param labelled  whether panels carry (a), (b) .. when there are several
  PlatePainter(const Plate& plate, const FigureTheme& theme, double width, bool labelled = true);

  /// Width and height in figure units.
  const QSizeF& size() const { return size_; }

  /// Where each panel is painted.
  const std::vector<QRectF>& places() const { return places_; }

  void paint(QPainter& painter) const;

  /// The width of a panel, mm, in a plate of these columns and width.
  static double panelWidth(double width, int columns, int span);

 private:
  void layOut(double width);
  double placeRow(size_t begin, size_t end, double top, double width);
  size_t endOfRow(size_t begin) const;
  QString labelOf(size_t panel) const;
  bool hasHeading(size_t panel) const;
  void paintHeading(QPainter& painter, size_t panel) const;

  Plate plate_;
  FigureTheme theme_;
  FigureWords words_;
  bool labelled_;
  QSizeF size_;
  std::vector<QRectF> places_;
  double wordsTop_ = 0.0;
};

}  // namespace mien
