#pragma once

#include <QPair>
#include <QSlider>
#include <optional>

namespace mien {

/// A slider that goes where it is clicked, with a notch at 0, the part between 0 and the handle filled, and a small
/// mark where the face is when that is not where the handle is (an animation or an expression moves it as well).
class ValueSlider : public QSlider {
  Q_OBJECT
 public:
  explicit ValueSlider(QWidget* parent = nullptr);

  void setShownValue(double value);  ///< where the mark is
  double shownValue() const { return shown_; }
  void setRangeMarks(std::optional<QPair<int, int>> range);                ///< brackets around some of the values
  void setDoubleClickResets(bool resets) { doubleClickResets_ = resets; }  ///< to 0; default off
  QSize sizeHint() const override { return {160, 20}; }
  QSize minimumSizeHint() const override { return {60, 20}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void paintRange(QPainter& painter) const;
  double position(double value) const;  ///< in pixels
  int valueAt(double x) const;

  double shown_ = 0.0;
  std::optional<QPair<int, int>> range_;
  bool doubleClickResets_ = false;
};

}  // namespace mien
