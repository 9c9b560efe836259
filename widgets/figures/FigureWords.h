#pragma once

#include <QFont>
#include <QString>
#include <QStringList>
#include <string>

#include "FigureTheme.h"

class QPainter;

namespace mien {

/// The words around a figure, broken into lines that fit its width: a title above, a caption and a note below.
class FigureWords {
 public:
  static constexpr double border = 1.5;  ///< mm, around every figure

  /// @param width   of the figure, mm
  /// @param family  of the font; empty: that of all figures
  FigureWords(const std::string& title, const std::string& caption, const std::string& note, double width,
              const QString& family = {});

  double titleHeight() const;  ///< figure units; 0 without a title
  double belowHeight() const;  ///< of caption and note together; 0 without both

  /// The title at the figure's top edge.
  void paintTitle(QPainter& painter, const FigureTheme& theme) const;

  /// Caption and note, from this y on.
  void paintBelow(QPainter& painter, const FigureTheme& theme, double y) const;

 private:
  struct Paragraph {
    QFont font;
    QStringList lines;

    double height() const;
    double paint(QPainter& painter, const FigureTheme& theme, double y) const;  ///< @return the y below it
  };

  Paragraph title_, caption_, note_;
};

}  // namespace mien
