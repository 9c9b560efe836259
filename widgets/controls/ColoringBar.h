#pragma once

#include "OverflowRow.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace mien {

class CurveOverlay;
class FaceColoring;

/// What the face is coloured by, the range of the colours, and whether its curves lie on it.
/// Its widgets are colorBy, colorAutomatic, colorBegin, colorEnd, faceCurves and faceCurveNames.
class ColoringBar : public OverflowRow {
  Q_OBJECT
 public:
  ColoringBar(FaceColoring* coloring, QWidget* parent = nullptr);

 signals:
  void colorChosen();  ///< by the user, after it has taken effect
  void curvesToggled(bool on);
  void namesToggled(bool on);

 private:
  void describe();
  void fillRow();
  static void keepPlace(QWidget* widget, bool keep);
  void showRange();
  QToolButton* toggle(const QString& name, const QString& text, const QString& toolTip);
  void list();
  void follow();

  FaceColoring* coloring_;
  QWidget* range_;
  QComboBox* choice_;
  QToolButton* automatic_;
  QDoubleSpinBox* begin_;
  QLabel* to_;
  QDoubleSpinBox* end_;
  QLabel* unit_;
};

}  // namespace mien
