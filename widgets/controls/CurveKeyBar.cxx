#include "CurveKeyBar.h"

#include <QPainter>
#include <QToolButton>

#include "ColorScale.h"
#include "CurveView.h"
#include "FootBand.h"
#include "RangeBox.h"

namespace mien {

namespace {

constexpr double longestRange = 200.0;  // mm

}  // namespace

CurveKeyBar::CurveKeyBar(CurveView* view, QWidget* parent)
    : OverflowRow("curveKey", parent), scale_(new ColorScale(view, this)) {
  auto* range = new RangeBox("curveRange", longestRange, this);
  range->setAccessibleName(tr("Movement of the last colour"));
  range->setToolTip(
      tr("The movement in mm that has the last colour. 0, automatic: a round number that holds the movement "
         "of the face shown and of all of its animation"));
  auto* head = new QToolButton(this);
  head->setObjectName("curveHead");
  head->setText(tr("Head"));
  head->setCheckable(true);
  head->setFocusPolicy(Qt::TabFocus);
  head->setToolTip(tr("Whether the turns of the head (FAP 48 to 50) count as movement of the curves"));
  setMargins(0, 0, 6, 2);
  setSpacing(4);
  addWidget(scale_);
  addWidget(range, 2);
  addWidget(head, 1);
  const auto follow = [view, range] { range->showAutomatic(view->automaticEnd()); };
  connect(range, QOverload<double>::of(&QDoubleSpinBox::valueChanged), view, &CurveView::setFixedRange);
  connect(head, &QToolButton::toggled, view, &CurveView::setWithHead);
  connect(view, &CurveView::movementChanged, this, follow);
  follow();
}

void CurveKeyBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintFoot(painter, rect());
}

}  // namespace mien
