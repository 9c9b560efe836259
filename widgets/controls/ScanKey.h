#pragma once

#include <QColor>
#include <QWidget>

namespace mien {

/// Which of two skins that show through each other is the scan, and which the face: a key in the lower left corner of a
/// view. Hidden at first.
class ScanKey : public QWidget {
  Q_OBJECT
 public:
  /// @param view  becomes the parent; the key follows its size
  ScanKey(const QColor& scan, QWidget* view);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QColor scan_;
};

}  // namespace mien
