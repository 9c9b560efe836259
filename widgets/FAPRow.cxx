#include "FAPRow.h"

#include "ValueSlider.h"
#include "FAPText.h"
#include "FaceState.h"
#include "Icons.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVariant>
#include <QToolButton>

#include <cmath>

namespace mien {

namespace {

constexpr int singleStep = 4, pageStep = 64;  // of the slider by keys, in FAP units

/// Of the slider, in FAP units; numbers may be larger. Lids close and mouths open within a whole unit; no other part
/// of a face moves by half of one.
int sliderRange(FAPUnit unit) {
  return unit == FAPUnit::IrisDiameter || unit == FAPUnit::MouthNoseSeparation ? 1024 : 512;
}

QString unitSuffix(FAPUnit unit) {
  const std::string_view name = symbol(unit);
  return " " + QString::fromUtf8(name.data(), static_cast<int>(name.size()));
}

}  // namespace

FAPRow::FAPRow(const FAPDefinition& fap, double millimetresPerUnit, QWidget* parent)
    : QWidget(parent), fap_(fap.number), millimetresPerUnit_(millimetresPerUnit), slider_(new ValueSlider(this)),
      number_(new QDoubleSpinBox(this)), length_(new QLabel(this)), reset_(new QToolButton(this)) {
  build(fap);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { edit(value); });
  connect(number_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &FAPRow::edit);
  connect(reset_, &QToolButton::clicked, this, [this] { edit(0.0); });
  display(0.0);
}

void FAPRow::build(const FAPDefinition& fap) {
  const QString label = fapLabel(fap), tip = fapToolTip(fap, millimetresPerUnit_);
  const int range = sliderRange(fap.unit);
  auto* name = new QLabel(label, this);
  slider_->setObjectName(QString("fapSlider%1").arg(fap_));
  slider_->setRange(fap.bidirectional ? -range : 0, range);
  slider_->setSingleStep(singleStep);
  slider_->setPageStep(pageStep);
  slider_->setDoubleClickResets(true);
  slider_->setAccessibleName(label);
  number_->setObjectName(QString("fapValue%1").arg(fap_));
  number_->setRange(-FaceState::largestFAPValue, FaceState::largestFAPValue);
  number_->setDecimals(0);
  number_->setSingleStep(10);
  number_->setSuffix(unitSuffix(fap.unit));
  number_->setKeyboardTracking(false);
  number_->setAccessibleName(label);
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFixedWidth(number_->fontMetrics().horizontalAdvance("-1024 IRISD") + 16);
  length_->setObjectName(QString("fapLength%1").arg(fap_));
  length_->setProperty("faint", true);
  reset_->setObjectName(QString("fapReset%1").arg(fap_));
  reset_->setIcon(icon(Symbol::Reset));
  reset_->setIconSize({12, 12});
  reset_->setToolTip(tr("Back to 0"));
  for (QWidget* widget : {static_cast<QWidget*>(name), static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_),
                          static_cast<QWidget*>(length_)})
    widget->setToolTip(tip);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(1);
  grid->addWidget(name, 0, 0);
  grid->addWidget(length_, 0, 1, 1, 2, Qt::AlignRight);
  grid->addWidget(slider_, 1, 0);
  grid->addWidget(number_, 1, 1);
  grid->addWidget(reset_, 1, 2);
  grid->setColumnStretch(0, 1);
}

double FAPRow::value() const { return number_->value(); }

void FAPRow::display(double value) {
  const QSignalBlocker quietSlider(slider_), quietNumber(number_);
  slider_->setValue(static_cast<int>(std::lround(value)));
  number_->setDecimals(value == std::floor(value) ? 0 : 2);
  number_->setValue(value);
  reset_->setEnabled(value != 0.0);
}

void FAPRow::setValue(double value) { display(value); }

void FAPRow::setShownValue(double value) {
  slider_->setShownValue(value);
  const double length = value * millimetresPerUnit_;
  length_->setText(millimetresPerUnit_ > 0.0 ? tr("%1 mm").arg(length, 0, 'f', 1) : QString());
}

void FAPRow::edit(double value) {
  display(value);
  emit valueEdited(fap_, value);
}

}  // namespace mien
