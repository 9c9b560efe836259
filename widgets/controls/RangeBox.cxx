#include "RangeBox.h"

namespace mien {

namespace {

constexpr int shownDecimals = 1;  // behind the point
constexpr int boxMargins = 16;    // pixels

}  // namespace

RangeBox::RangeBox(const QString& objectName, double most, QWidget* parent) : SignedNumberBox(parent) {
  setObjectName(objectName);
  setDecimals(shownDecimals);
  setRange(0.0, most);
  setSuffix(tr(" mm"));
  setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  setKeyboardTracking(false);
  setButtonSymbols(QAbstractSpinBox::NoButtons);
  setAlignment(Qt::AlignRight);
  showAutomatic(0.0);
  setFixedWidth(fontMetrics().horizontalAdvance(tr("auto %1 mm").arg(88)) + boxMargins);
}

void RangeBox::showAutomatic(double end) {
  if (end == automatic_ && !specialValueText().isEmpty()) return;
  automatic_ = end;
  setSpecialValueText(end > 0.0 ? tr("auto %1 mm").arg(QString::number(end, 'g', 4)) : tr("automatic"));
}

void RangeBox::stepBy(int steps) {
  if (isAutomatic() && steps > 0 && automatic_ > 0.0) return setValue(automatic_);
  SignedNumberBox::stepBy(steps);
}

}  // namespace mien
