#pragma once

#include <QWidget>

class QBoxLayout;

namespace mien {

/// Two widgets beside each other where there is width, one above the other where there is height.
class FlipBox : public QWidget {
  Q_OBJECT
 public:
  FlipBox(QWidget* first, QWidget* second, int firstShare, int secondShare, QWidget* parent = nullptr);

  /// Beside each other the first has the width that it asks for, whatever its share, as long as the second has this.
  /// @param leastSecond  pixels
  void showAllOfFirst(int leastSecond);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void giveWidths(bool beside, int room);

  QBoxLayout* layout_;
  QWidget* first_;
  int firstShare_, secondShare_, leastSecond_ = 0;
};

}  // namespace mien
