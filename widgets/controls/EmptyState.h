#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace mien {

/// What stands in a dock while it has nothing to show: what that would be, what to do, and buttons that do it at once.
class EmptyState : public QWidget {
  Q_OBJECT
 public:
  EmptyState(const QString& name, const QString& title, const QString& text, QWidget* parent = nullptr);

  void setText(const QString& text);
  QToolButton* addButton(const QString& name, const QString& text, const QString& toolTip);

 private:
  QLabel* text_;
  QHBoxLayout* buttons_;
};

}  // namespace mien
