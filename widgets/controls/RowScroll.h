#pragma once

#include <QScrollArea>

namespace mien {

/// Scrolls a column of rows, and ends below a whole one: in its first place no row is cut through.
class RowScroll : public QScrollArea {
  Q_OBJECT
 public:
  explicit RowScroll(QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
  int endOfRows(int room) const;

  bool fitting_ = false;
};

}  // namespace mien
