#pragma once

#include <QWidget>

namespace mien {

class FaceModel;

/// The key of the curve view, below it: which colour means which movement, how far the face moves at most now, and a
/// pointed end where that lies beyond the colours.
class ColorScale : public QWidget {
  Q_OBJECT
 public:
  explicit ColorScale(FaceModel* model, QWidget* parent = nullptr);

  double most() const { return most_; }  ///< mm that a point of a curve has moved
  bool isExceeded() const;               ///< whether that is more than the colours tell

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void follow();
  void paintBar(QPainter& painter, const QRectF& bar) const;

  FaceModel* model_;
  double most_ = 0.0;
};

}  // namespace mien
