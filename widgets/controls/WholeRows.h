#pragma once

#include <QWidget>

class QTableView;

namespace mien {

/// Holds a table so that it ends below a whole row: in a low place with fewer rows, the rest to be scrolled to; in a
/// high one with all of them, which grow before anything is left over below.
class WholeRows : public QWidget {
  Q_OBJECT
 public:
  /// @param table       becomes a child; its rows are of one height, which is set here
  /// @param leastRow    pixels of a row, where not all of them have room
  /// @param mostRow     pixels of a row, where there is more room than that
  WholeRows(QTableView* table, int leastRow, int mostRow, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void place();
  int around() const;

  QTableView* table_;
  int leastRow_, mostRow_;
};

}  // namespace mien
