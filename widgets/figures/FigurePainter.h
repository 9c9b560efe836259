#pragma once

#include <QSizeF>

#include "ChartPainter.h"
#include "Figure.h"
#include "FigureWords.h"
#include "LegendPainter.h"

namespace mien {

/// Lays a figure out and draws it, on paper or on a widget: title, legend, panels, caption, note.
///
/// Everything is in hundredths of a millimetre; type keeps its size whatever the figure's width. Needs a
/// FigureApplication, for its fonts.
class FigurePainter {
 public:
  /// @param width   of the figure, mm
  /// @param height  mm; 0: what the panels need
  FigurePainter(const Figure& figure, const FigureTheme& theme, double width, double height = 0.0);

  /// Width and height in figure units.
  const QSizeF& size() const { return size_; }

  void paint(QPainter& painter) const;

  /// The panels in their places, to find values under a pointer.
  const std::vector<ChartPainter>& panels() const { return panels_; }

 private:
  void layOut(double height);
  void placePanels(double top, double cellHeight, const ChartPainter::Margins& margins);
  int columnCount() const;
  int rowCount() const;
  double cellWidth() const;
  ChartPainter::Margins commonMargins(double plotHeight) const;

  Figure figure_;
  FigureTheme theme_;
  QSizeF size_;
  double inner_;  ///< width without the border
  LegendPainter legend_;
  FigureWords words_;
  std::vector<ChartPainter> panels_;
  double legendTop_ = 0.0, textTop_ = 0.0;
};

}  // namespace mien
