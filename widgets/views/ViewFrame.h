#pragma once

#include <QFrame>
#include <vector>

class QGridLayout;
class QToolButton;

namespace mien {

class ElidedLabel;
class OverflowRow;

/// A view with its title and its buttons above it; the title has its width first, and where there is no room for all,
/// the last of the buttons wait behind "more".
class ViewFrame : public QFrame {
  Q_OBJECT
 public:
  ViewFrame(const QString& title, QWidget* view, QWidget* parent = nullptr);

  void setTitle(const QString& title);
  QToolButton* addButton(const QString& objectName, const QString& text, const QString& toolTip);
  /// One that never waits behind "more".
  QToolButton* addLastingButton(const QString& objectName, const QString& text, const QString& toolTip);
  QToolButton* addToggle(const QString& objectName, const QString& text, const QString& toolTip, bool on);
  void addControl(QWidget* control);  ///< in the head, after what is there
  void addGap();
  void addBelow(QWidget* widget);
  void addFoot(QWidget* widget);  ///< over the lower edge of the view

 protected:
  void showEvent(QShowEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QToolButton* button(const QString& objectName, const QString& text, const QString& toolTip);

  OverflowRow* header_;
  QGridLayout* stage_;
  int controls_ = 0;
  QWidget* view_;
  ElidedLabel* name_;
  std::vector<QToolButton*> lasting_;
};

}  // namespace mien
