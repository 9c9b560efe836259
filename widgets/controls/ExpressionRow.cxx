#include "ExpressionRow.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QSpinBox>
#include <QVariant>

#include "PercentSlider.h"
#include "SignedBox.h"
#include "ValueSlider.h"

namespace mien {

namespace {

constexpr int nameWidth = 84;  // pixels: the longest name, so that sliders begin below each other

}  // namespace

ExpressionRow::ExpressionRow(const QString& name, const QString& definition, QWidget* parent)
    : QWidget(parent),
      name_(new QPushButton(this)),
      slider_(new ValueSlider(this)),
      percent_(new SignedWholeBox(this)) {
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
  percent_->setObjectName("expressionPercent_" + name);
  makePercent(slider_, percent_, tr("Intensity of %1").arg(name), definition);
}

void ExpressionRow::setPercent(int percent) {
  showPercent(slider_, percent_, percent);
  name_->setChecked(percent > 0);
}

}  // namespace mien
