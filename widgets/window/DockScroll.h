#pragma once

#include "RowScroll.h"

namespace mien {

/// Lets a dock be smaller than what it holds, down to a size in which that can still be used; then it scrolls.
class DockScroll : public RowScroll {
  Q_OBJECT
 public:
  explicit DockScroll(QWidget* panel);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
};

}  // namespace mien
