#pragma once

#include <vtkNew.h>

#include <QColor>
#include <QString>

class vtkLookupTable;
class vtkPolyDataMapper;

namespace mien {

/// How values become colours in a view. What they mean stands beside it.
/// @sa ColorKey
class ColorLegend {
 public:
  enum class Colors {
    Sequential,  ///< from the smallest up
    Diverging    ///< both signs, 0 in the middle
  };

  /// Ranges are given, never taken from the data by themselves.
  struct Scale {
    QString title;  ///< with unit
    double begin = 0.0, end = 1.0;
    Colors colors = Colors::Sequential;
    void mark(const double range[2]);         ///< tells whether values of that range lie outside
    bool undercut = false, exceeded = false;  ///< whether values lie before its begin, beyond its end
    QString unknown = {};                     ///< in words, what has no number and is grey; empty: there is none
  };

  ColorLegend();
  ~ColorLegend();

  void setScale(const Scale& scale);
  void setPatches();  ///< a colour for each of the values 0 .. 8

  /// The colour of a share (0 .. 1) of a scale.
  static QColor colorAt(Colors colors, double share);

  static QColor unknownColor();  ///< neutral, of what has no number

  /// Gives a mapper these colours for the values that it has chosen.
  /// @param component  of values with several; -1: their length
  void color(vtkPolyDataMapper* mapper, int component = -1) const;

 private:
  vtkNew<vtkLookupTable> colors_;
};

}  // namespace mien
