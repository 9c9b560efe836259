#pragma once

#include "OverflowRow.h"

namespace mien {

class ColorScale;
class CurveView;

/// Below the curve view: what its colours mean, and what changes that. Its widgets are curveScale, curveRange and
/// curveHead.
class CurveKeyBar : public OverflowRow {
  Q_OBJECT
 public:
  explicit CurveKeyBar(CurveView* view, QWidget* parent = nullptr);

  ColorScale* scale() const { return scale_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ColorScale* scale_;
};

}  // namespace mien
