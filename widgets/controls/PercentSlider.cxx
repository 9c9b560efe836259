#include "PercentSlider.h"

#include <QSignalBlocker>
#include <QSpinBox>

#include "ValueSlider.h"

namespace mien {

namespace {

constexpr int full = 100;  // percent

}  // namespace

void makePercent(ValueSlider* slider, QSpinBox* box, const QString& name, const QString& tip) {
  slider->setRange(0, full);
  slider->setPageStep(10);
  slider->setDoubleClickResets(true);
  slider->setAccessibleName(name);
  slider->setToolTip(tip);
  box->setRange(0, full);
  box->setToolTip(tip);
  box->setSuffix(" %");
  box->setAlignment(Qt::AlignRight);
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setAccessibleName(name);
  const QFontMetrics metrics = box->fontMetrics();
  box->setFixedSize(metrics.horizontalAdvance("100 %") + 18, metrics.height() + 10);
}

void showPercent(ValueSlider* slider, QSpinBox* box, int percent) {
  const QSignalBlocker quietSlider(slider), quietBox(box);
  slider->setValue(percent);
  slider->setShownValue(percent);
  box->setValue(percent);
}

}  // namespace mien
