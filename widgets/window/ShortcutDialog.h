#pragma once

#include <QDialog>

class QLineEdit;
class QTableWidget;

namespace mien {

/// The keys of a window as a table that can be searched; made from the window as it is.
/// @sa shortcutsOf
class ShortcutDialog : public QDialog {
  Q_OBJECT
 public:
  ShortcutDialog(const QWidget& window, QWidget* parent);

 private:
  void fill(const QWidget& window);
  void filter();

  QLineEdit* search_;
  QTableWidget* table_;
};

}  // namespace mien
