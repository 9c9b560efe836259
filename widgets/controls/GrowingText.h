#pragma once

#include <QPlainTextEdit>

namespace mien {

/// A text to be read, as high as it needs to be: whatever it lies in scrolls, and it never does itself. Lines may have
/// a tooltip each.
class GrowingText : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit GrowingText(QWidget* parent = nullptr);

  void setDetails(
      const QStringList& details);  ///< of each line; beyond them, and where one is empty, the tooltip of all

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void grow();

  QStringList details_;
};

}  // namespace mien
