#pragma once

#include <QWidget>

#include "MotionVectorOptions.h"
#include "SessionPart.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;

namespace mien {

class MotionVectorFigure;
class RenderView;

/// How is a motion vector field drawn? View, region, sampling, arrows, colours, below each other. Its widgets
/// are named vectorsView, vectorsRegion, vectorsSampling, vectorsSpacing, vectorsScale, vectorsScaleValue,
/// vectorsLength, vectorsColor, vectorsColorMap, vectorsRange, vectorsRangeValue, vectorsHead, vectorsWhole and
/// vectorsSeams.
class VectorControls : public QWidget, public SessionPart {
  Q_OBJECT
 public:
  /// @param view  whose direction can be taken over
  VectorControls(RenderView* view, QWidget* parent = nullptr);

  /// Without region, size and theme.
  MotionVectorOptions options() const;

  std::string region() const;  ///< as VectorRegion reads it; empty: the whole face
  QString viewName() const;    ///< in words
  bool headMotionRemoved() const;
  void showInEffect(const MotionVectorFigure& figure);  ///< what automatic choices have come to, in their places
  bool followsView() const;                             ///< whether the direction is that of the other view

  /// A rectangle in the picture, mm to the right and up; it is the last of the list of regions, in the place of one
  /// before.
  void setRegion(const Eigen::AlignedBox2d& rectangle);
  void setWholeRegion();

  nlohmann::json sessionState() const override;  ///< `dragged`: the rectangle, as VectorRegion reads it
  QString changeName() const override { return tr("Region"); }
  void restoreSession(const nlohmann::json& state) override;

 signals:
  void changed();
  void scaleChanged();  ///< before changed(), when scale and range may be chosen anew

 private:
  QComboBox* list(const char* name, const QStringList& entries, const QString& tip);
  QDoubleSpinBox* number(const char* name, double least, double most, double value, const QString& unit,
                         const QString& tip);
  QCheckBox* check(const char* name, const QString& text, const QString& tip);
  void add(const QString& name, QWidget* first, QWidget* second = nullptr);
  void buildPicture();
  void buildArrows();
  void connectAll();
  void followChoices();
  void showSpacing(bool isEven);
  void listDragged(const QString& name);
  void look(PicturePlane& plane) const;

  RenderView* other_;
  QGridLayout* grid_;
  int count_ = 0;  ///< of what add() has added
  QComboBox *view_, *region_, *sampling_, *scale_, *length_, *color_, *map_, *range_;
  QDoubleSpinBox *spacing_, *scaleValue_, *rangeValue_;
  QCheckBox *head_, *whole_, *seams_;
};

}  // namespace mien
