#pragma once

#include <QWidget>
#include <vector>

class QHBoxLayout;
class QToolButton;
class QVBoxLayout;

namespace mien {

/// Controls in one row, whatever its width: those for which there is no room wait in a panel that the button at its end
/// opens. Nothing is cut off, and nothing stands in a line of its own.
class OverflowRow : public QWidget {
  Q_OBJECT
 public:
  /// @param name  of the row; its button is that with "More"
  explicit OverflowRow(const QString& name, QWidget* parent = nullptr);

  /// @param rank  those of the greatest leave the row first, of one rank the last; of 0 never
  void addWidget(QWidget* widget, int rank = 0);
  void addLabelled(const QString& label, QWidget* widget, int rank = 0);  ///< stay together
  void addSpacing(int pixels);
  void addStretch();
  void setMargins(int left, int top, int right, int bottom);
  void setSpacing(int pixels);

  bool isInPanel(const QWidget* widget) const { return widget->parentWidget() == panel_; }
  QToolButton* more() const { return more_; }  ///< shown where there is something in the panel

  QSize sizeHint() const override;         ///< of all in the row
  QSize minimumSizeHint() const override;  ///< of those that never leave it, and the button

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Item {
    QWidget* widget;  ///< nullptr: room
    int rank, pixels;
  };
  bool takesRoom(const Item& item) const;
  int widthOf(const std::vector<bool>& leaves) const;
  std::vector<bool> leaving() const;
  void arrange();
  void move(QWidget* widget, bool toPanel);
  void orderFocus();
  void openPanel();

  std::vector<Item> items_;
  QHBoxLayout* row_;
  QToolButton* more_;
  QWidget* panel_;
  QVBoxLayout* column_;
  bool arranging_ = false;
};

}  // namespace mien
