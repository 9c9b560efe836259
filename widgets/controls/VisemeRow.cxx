#include "VisemeRow.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVariant>
#include <iterator>

#include "AnimationData.h"
#include "ExpressionLibrary.h"
#include "PercentSlider.h"
#include "SignedBox.h"
#include "ValueSlider.h"
#include "vtkFAPAnimationFilter.h"

namespace mien {

namespace {

/// Words that are said with the visemes 1 .. 14, as the standard lists them (ISO/IEC 14496-2, table C.5).
constexpr const char* examples[] = {"put, bed, mill",
                                    "far, voice",
                                    "think, that",
                                    "tip, doll",
                                    "call, gas",
                                    "chair, join, she",
                                    "sir, zeal",
                                    "lot, not",
                                    "red",
                                    "car",
                                    "bed",
                                    "tip",
                                    "top",
                                    "book"};

}  // namespace

VisemeRow::VisemeRow(int number, QWidget* parent)
    : QWidget(parent), name_(new QComboBox(this)), slider_(new ValueSlider(this)), percent_(new SignedWholeBox(this)) {
  build(number);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(name_);
  row->addWidget(slider_, 1);
  row->addWidget(percent_);
  connect(name_, QOverload<int>::of(&QComboBox::activated), this,
          [this] { emit chosen(QString::fromStdString(name())); });
  connect(slider_, &QSlider::valueChanged, this, &VisemeRow::percentEdited);
  connect(percent_, QOverload<int>::of(&QSpinBox::valueChanged), this, &VisemeRow::percentEdited);
}

void VisemeRow::build(int number) {
  const QString which = QString::number(number);
  name_->setObjectName("visemeName" + which);
  name_->setAccessibleName(number == 1 ? tr("First viseme") : tr("Second viseme"));
  name_->setToolTip(tr("What the mouth says (a viseme of MPEG-4, FAP 1); two of them mix"));
  name_->addItem(number == 1 ? tr("No viseme") : tr("No second viseme"), QString());
  const std::vector<std::string> names = vtkFAPAnimationFilter::GetVisemeNames();
  for (size_t i = 0; i < names.size(); ++i) {
    const QString text = QString::fromStdString(names[i]);
    name_->addItem(i < std::size(examples) ? tr("%1  (%2)").arg(text, examples[i]) : text, text);
    if (const ExpressionProfile* found = defaultVisemes().find(names[i]))
      name_->setItemData(name_->count() - 1, QString::fromStdString(found->definition), Qt::ToolTipRole);
  }
  name_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  name_->setMinimumContentsLength(13);
  name_->setMaxVisibleItems(name_->count());
  slider_->setObjectName("visemeSlider" + which);
  percent_->setObjectName("visemePercent" + which);
  makePercent(slider_, percent_, tr("Strength of the viseme"), tr("How strong the viseme is"));
}

std::string VisemeRow::name() const {
  return name_->currentData().toString().toStdString();
}

void VisemeRow::show(const std::string& name, int percent) {
  const QSignalBlocker quiet(name_);
  name_->setCurrentIndex(std::max(0, name_->findData(QString::fromStdString(name))));
  showPercent(slider_, percent_, percent);
  slider_->setEnabled(!name.empty());
  percent_->setEnabled(!name.empty());
}

}  // namespace mien
