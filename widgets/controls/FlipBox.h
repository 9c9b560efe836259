#pragma once

#include <QWidget>

class QBoxLayout;

namespace mien {

/// Two widgets beside each other where there is width, one above the other where there is height.
class FlipBox : public QWidget {
  Q_OBJECT
 public:
  FlipBox(QWidget* first, QWidget* second, int firstShare, int secondShare, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QBoxLayout* layout_;
};

}  // namespace mien
