#include "ExpressionRow.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVariant>

#include "ValueSlider.h"

namespace mien {

namespace {

constexpr int full = 100;      // percent
constexpr int nameWidth = 84;  // pixels: the longest name, so that sliders begin below each other

}  // namespace

ExpressionRow::ExpressionRow(const QString& name, const QString& definition, QWidget* parent)
    : QWidget(parent), name_(new QPushButton(this)), slider_(new ValueSlider(this)), percent_(new QSpinBox(this)) {
  build(name, definition);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(name_);
  row->addWidget(slider_, 1);
  row->addWidget(percent_);
  connect(name_, &QPushButton::clicked, this, &ExpressionRow::chosenAlone);
  connect(slider_, &QSlider::valueChanged, this, &ExpressionRow::percentEdited);
  connect(percent_, QOverload<int>::of(&QSpinBox::valueChanged), this, &ExpressionRow::percentEdited);
}

void ExpressionRow::build(const QString& name, const QString& definition) {
  const QString title = name.left(1).toUpper() + name.mid(1);
  name_->setText(title);
  name_->setObjectName("expression_" + name);
  name_->setCheckable(true);
  name_->setProperty("compact", true);
  name_->setFixedWidth(nameWidth);
  name_->setToolTip(
      tr("%1<br>Click for this expression alone, again for the neutral face; sliders mix.").arg(definition));
  slider_->setObjectName("expressionSlider_" + name);
  slider_->setRange(0, full);
  slider_->setPageStep(10);
  slider_->setDoubleClickResets(true);
  slider_->setAccessibleName(tr("Intensity of %1").arg(name));
  slider_->setToolTip(definition);
  percent_->setObjectName("expressionPercent_" + name);
  percent_->setRange(0, full);
  percent_->setSuffix(" %");
  percent_->setAlignment(Qt::AlignRight);
  percent_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  percent_->setAccessibleName(slider_->accessibleName());
  const QFontMetrics metrics = percent_->fontMetrics();
  percent_->setFixedSize(metrics.horizontalAdvance("100 %") + 18, metrics.height() + 10);
}

void ExpressionRow::setPercent(int percent) {
  const QSignalBlocker quietSlider(slider_), quietPercent(percent_);
  slider_->setValue(percent);
  slider_->setShownValue(percent);
  percent_->setValue(percent);
  name_->setChecked(percent > 0);
}

}  // namespace mien
