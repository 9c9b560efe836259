#pragma once

#include <QWidget>
#include <vector>

namespace mien {

class CurveView;

/// The key of the curve view, below it: which colour means which movement, whether the turns of the head count, how far
/// a curve moves at most now, and a pointed end where that lies beyond the colours.
class ColorScale : public QWidget {
  Q_OBJECT
 public:
  explicit ColorScale(CurveView* view, QWidget* parent = nullptr);

  bool isExceeded() const;  ///< whether something has moved further than the colours tell

  /// Where the numbers below a bar stand, those of its ends first, in pixels.
  std::vector<QRectF> numberPlaces(const QRectF& bar) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString title() const;
  bool isNarrow() const;
  int titleWidth(bool narrow) const;
  int roomAfter() const;
  void paintNumbers(QPainter& painter, const QRectF& bar, double low) const;
  void paintBar(QPainter& painter, const QRectF& bar) const;

  CurveView* view_;
};

}  // namespace mien
