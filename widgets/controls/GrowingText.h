#pragma once

#include <QPlainTextEdit>

namespace mien {

/// A text to be read, as high as it needs to be: whatever it lies in scrolls, and it never does itself.
class GrowingText : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit GrowingText(QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void grow();
};

}  // namespace mien
