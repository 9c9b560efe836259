#pragma once

#include <QFrame>
#include <vector>

class QToolButton;

namespace mien {

class ElidedLabel;
class WrappingRow;

/// A view with its title and its buttons above it.
class ViewFrame : public QFrame {
  Q_OBJECT
 public:
  ViewFrame(const QString& title, QWidget* view, QWidget* parent = nullptr);

  void setTitle(const QString& title);
  QToolButton* addButton(const QString& objectName, const QString& text, const QString& toolTip);
  QToolButton* addToggle(const QString& objectName, const QString& text, const QString& toolTip, bool on);
  void addControl(QWidget* control);  ///< in the head, after what is there
  void addGap();
  void addBelow(QWidget* widget);

  /// Frames side by side have heads of one height, however many lines the buttons of each need; one alone has its own.
  static void alignHeads(const std::vector<ViewFrame*>& frames);

 signals:
  void resized();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  WrappingRow* header_;
  ElidedLabel* name_;
};

}  // namespace mien
