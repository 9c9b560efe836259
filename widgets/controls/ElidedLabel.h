#pragma once

#include <QLabel>

namespace mien {

/// One line of text that ends in dots where it has no room; its tool tip then begins with the whole of it.
class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  /// The part of the text that there is room for.
  QString shownText() const;

  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace mien
