#pragma once

#include <QWidget>

namespace mien {

/// The place of a key below a view, which it has whether the key is shown or hidden: what is chosen as colour does not
/// make the view larger or smaller.
class KeyStrip : public QWidget {
  Q_OBJECT
 public:
  KeyStrip(QWidget* key, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace mien
