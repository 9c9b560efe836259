#pragma once

#include <QScrollArea>

class QBoxLayout;

namespace mien {

/// Scrolls a column of rows, and ends below a whole one: in its first place no row is cut through. The bar is there
/// when not all rows have room, and then beside them.
class RowScroll : public QScrollArea {
  Q_OBJECT
 public:
  explicit RowScroll(QWidget* parent = nullptr);

  /// Rows of one height in the page that move apart where whole ones would leave a gap below them, and together where
  /// one more then has room.
  void spread(QBoxLayout* rows);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void fit();
  void fitBar();
  void spreadRows(int room);
  int room() const;
  int need() const;
  int endOfRows(int room) const;

  QBoxLayout* spread_ = nullptr;
  int usualSpacing_ = 0;
  bool fitting_ = false;
};

}  // namespace mien
