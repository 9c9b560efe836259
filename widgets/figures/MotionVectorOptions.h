#pragma once

#include <QColor>
#include <array>
#include <optional>
#include <string>

#include "VectorPicture.h"

namespace mien {

/// How a motion field is drawn. Length, direction and colour of the arrows are independent of each other.
struct MotionVectorOptions {
  enum class Length {
    Seen,     ///< the vector as the view shows it, like everything else in the picture
    InSpace,  ///< its length in space, along the direction in which it is seen
    Equal     ///< all arrows alike, which shows directions
  };
  enum class Color {
    Magnitude,  ///< length in space, mm
    Towards,    ///< component towards the viewer, mm
    None        ///< all arrows in the colour of the text
  };

  VectorPictureOptions picture;  ///< view, region, sampling, hidden vectors

  std::optional<double> scale;  ///< mm of motion per mm of arrow, above 0; without it a round one is chosen
  bool trueToFace = false;      ///< arrows as large as the face is drawn: their tips are where the points go
  std::optional<std::array<double, 2>> range;  ///< mm at the ends of the colours; without it from the vectors
  Length length = Length::Seen;
  Color color = Color::Magnitude;
  std::string colorMap;    ///< of ColorTable; "_r" behind the name turns it around; empty: viridis, towards coolwarm
  bool keyBeside = false;  ///< the key stands to the right of the panels, not below them
  bool seams = true;       ///< whether the lines between patches are drawn

  std::string theme = "light";       ///< of FigureTheme
  QColor background;                 ///< invalid: the theme's
  std::string font;                  ///< family; empty: that of all figures
  double width = 85.0;               ///< of the figure, mm
  double height = 0.0;               ///< mm; 0: what the panels need
  bool labelled = true;              ///< (a), (b) .. before several panels
  bool asRow = false;                ///< headings as those of PanelRow, in the middle of their faces
  int columns = 0;                   ///< of panels; 0: as many as fit legibly
  std::string title, caption, note;  ///< around the panels; may be empty; the sampling is added to the note
};

}  // namespace mien
