#pragma once

#include <Eigen/Geometry>
#include <QPixmap>
#include <QWidget>
#include <memory>
#include <optional>

namespace mien {

class MotionVectorFigure;

/// A motion vector figure on the screen, as large as its widget; a rectangle dragged in it is a region of the face.
class VectorView : public QWidget {
  Q_OBJECT
 public:
  explicit VectorView(const QString& objectName, QWidget* parent = nullptr);
  ~VectorView() override;

  void setFigure(std::shared_ptr<const MotionVectorFigure> figure);
  const MotionVectorFigure* figure() const { return figure_.get(); }

  /// What stands in place of a figure.
  void setHint(const QString& hint);

  /// Where a place on the face (mm to the right, up in the picture) lies, in pixels.
  QPointF pixelOf(const Eigen::Vector2d& place) const;

  QSize sizeHint() const override { return {420, 340}; }
  QSize minimumSizeHint() const override { return {200, 170}; }

 signals:
  void dragged(const Eigen::AlignedBox2d& region);  ///< mm to the right, up in the picture
  void wholeAsked();                                ///< by a double click or Escape
  void resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Eigen::Vector2d placeOf(const QPointF& pixel) const;
  QPointF shift() const;  ///< of the figure, which stands in the middle, in pixels
  void drawPicture();

  std::shared_ptr<const MotionVectorFigure> figure_;
  QString hint_;
  QPixmap picture_;
  std::optional<QPoint> start_;
  QRect band_;
};

}  // namespace mien
