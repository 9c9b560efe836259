#include "FAPRow.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "ElidedLabel.h"
#include "FAPText.h"
#include "FaceState.h"
#include "Icons.h"
#include "SignedBox.h"
#include "ValueSlider.h"

namespace mien {

namespace {

constexpr int singleStep = 4, pageStep = 64;                // of the slider by keys, in FAP units
constexpr int singleAngleStep = 500, pageAngleStep = 5000;  // the same for angles: 0.3 and 3 degrees
constexpr int numberMargins = 12;                           // pixels, of the field
constexpr double degreesPerAngleUnit = radiansPerAngleUnit * 57.29577951308232;

/// Of the slider, in FAP units; numbers may be larger. Lids close and mouths open within a whole unit; no other part
/// of a face moves by half of one. A head turns by 0.6 rad with ease.
int sliderRange(FAPUnit unit) {
  if (unit == FAPUnit::Angle) return 60000;
  return unit == FAPUnit::IrisDiameter || unit == FAPUnit::MouthNoseSeparation ? 1024 : 512;
}

QString unitSuffix(FAPUnit unit) {
  const std::string_view name = symbol(unit);
  return " " + QString::fromUtf8(name.data(), static_cast<int>(name.size()));
}

}  // namespace

FAPRow::FAPRow(const FAPDefinition& fap, double millimetresPerUnit, QWidget* parent)
    : QWidget(parent),
      fap_(fap.number),
      unit_(fap.unit),
      millimetresPerUnit_(millimetresPerUnit),
      hasPartner_(fap.mirrorPartner != fap.number),
      slider_(new ValueSlider(this)),
      number_(new SignedNumberBox(this)),
      name_(new ElidedLabel(this)),
      length_(new QLabel(this)),
      reset_(new QToolButton(this)) {
  build(fap);
  display(0.0);
  setShownValue(0.0);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { edit(value); });
  connect(number_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &FAPRow::edit);
  connect(reset_, &QToolButton::clicked, this, [this] { edit(0.0); });
}

void FAPRow::build(const FAPDefinition& fap) {
  buildSlider(fap);
  buildNumber(fap);
  name_->setText(fapLabel(fap));
  name_->setObjectName(QString("fapName%1").arg(fap_));
  length_->setObjectName(QString("fapLength%1").arg(fap_));
  length_->setProperty("faint", true);
  length_->setAlignment(Qt::AlignRight);
  length_->setMinimumWidth(
      length_->fontMetrics().horizontalAdvance(withRealMinus("-88.8 mm")));  // what is beside it stays
  reset_->setObjectName(QString("fapReset%1").arg(fap_));
  reset_->setIcon(icon(Symbol::Reset));
  reset_->setIconSize({12, 12});
  reset_->setToolTip(tr("Back to 0"));
  explain(fapToolTip(fap, millimetresPerUnit_));
  layOut();
}

void FAPRow::buildSlider(const FAPDefinition& fap) {
  const bool isAngle = unit_ == FAPUnit::Angle;
  const int range = sliderRange(unit_);
  slider_->setObjectName(QString("fapSlider%1").arg(fap_));
  slider_->setRange(fap.bidirectional ? -range : 0, range);
  slider_->setSingleStep(isAngle ? singleAngleStep : singleStep);
  slider_->setPageStep(isAngle ? pageAngleStep : pageStep);
  slider_->setDoubleClickResets(true);
  slider_->setAccessibleName(fapLabel(fap));
}

void FAPRow::buildNumber(const FAPDefinition& fap) {
  number_->setObjectName(QString("fapValue%1").arg(fap_));
  number_->setRange(-FaceState::largestFAPValue, FaceState::largestFAPValue);
  number_->setDecimals(0);
  number_->setSingleStep(unit_ == FAPUnit::Angle ? singleAngleStep : 10);
  number_->setFocusPolicy(Qt::StrongFocus);
  number_->installEventFilter(this);
  number_->setSuffix(unitSuffix(unit_));
  number_->setKeyboardTracking(false);
  number_->setAccessibleName(fapLabel(fap));
  number_->setAlignment(Qt::AlignRight);
  number_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  number_->setFixedSize(number_->fontMetrics().horizontalAdvance(withRealMinus("-1024 IRISD")) + numberMargins,
                        number_->fontMetrics().height() + 10);
}

void FAPRow::layOut() {
  auto* upper = new QHBoxLayout;
  upper->addWidget(name_, 1);
  upper->addWidget(length_);
  auto* lower = new QHBoxLayout;
  lower->setSpacing(6);
  lower->addWidget(slider_, 1);
  lower->addWidget(number_);
  lower->addWidget(reset_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(upper);
  column->addLayout(lower);
}

/// Only with focus, so that scrolling a list does not move the face.
bool FAPRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Wheel || number_->hasFocus()) return QWidget::eventFilter(watched, event);
  event->ignore();
  return true;
}

double FAPRow::value() const {
  return number_->value();
}

void FAPRow::display(double value) {
  const QSignalBlocker quietSlider(slider_), quietNumber(number_);
  slider_->setValue(static_cast<int>(std::lround(value)));
  number_->setDecimals(value == std::floor(value) ? 0 : 2);
  number_->setValue(value);
  reset_->setEnabled(value != 0.0);
}

void FAPRow::setValue(double value) {
  if (value != number_->value()) display(value);
}

void FAPRow::setShownValue(double value) {
  slider_->setShownValue(value);
  const bool isAngle = unit_ == FAPUnit::Angle;
  const double tenths =
      std::round(10.0 * value * (isAngle ? degreesPerAngleUnit : millimetresPerUnit_)) + 0.0;  // no -0
  length_->setText((isAngle ? tr("%1\u00b0") : tr("%1 mm")).arg(withRealMinus(QString::number(0.1 * tenths, 'f', 1))));
  isMoreShown_ = std::lround(value) != std::lround(number_->value());
  showTips();
}

void FAPRow::setPartnerShown(bool shown) {
  const QString label = fapLabel(fapDefinition(fap_));
  name_->setText(hasPartner_ && shown ? label + " \u21c4" : label);
}

void FAPRow::setReason(const QString& whyNot) {
  setEnabled(whyNot.isEmpty());
  const QString tip = fapToolTip(fapDefinition(fap_), millimetresPerUnit_);
  explain(whyNot.isEmpty() ? tip : whyNot + "<br>" + tip);
}

void FAPRow::explain(const QString& tip) {
  tip_ = tip;
  for (QWidget* widget : {static_cast<QWidget*>(name_), static_cast<QWidget*>(number_)}) widget->setToolTip(tip);
  showTips();
}

/// Where what the face shows is seen: why it is not what was set here.
void FAPRow::showTips() {
  const QString more =
      tr("<b>%1</b> in all, from expressions and the animation too: the triangle below the slider.<br>%2");
  const QString tip = isMoreShown_ ? more.arg(length_->text(), tip_) : tip_;
  if (tip == length_->toolTip()) return;
  length_->setToolTip(tip);
  slider_->setToolTip(tip);
}

void FAPRow::edit(double value) {
  display(value);
  emit valueEdited(fap_, value);
}

}  // namespace mien
