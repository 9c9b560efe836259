#include "DeformationChoice.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <cmath>

#include "DeformationText.h"
#include "FaceModel.h"
#include "FileDialog.h"
#include "NamedTables.h"
#include "SignedBox.h"
#include "TableTitle.h"
#include "ValueSlider.h"

namespace mien {

namespace {

constexpr double percentOfAll = 100.0;
constexpr int mostPercent = static_cast<int>(percentOfAll * FaceState::largestStrength);

QString capitalised(const std::string& name) {
  const QString text = QString::fromStdString(name);
  return text.left(1).toUpper() + text.mid(1);
}

QString origin(const DeformationTable& table) {
  return table.deviations ? DeformationChoice::tr("Mean over subjects, with standard deviations")
                          : DeformationChoice::tr("Table I of Obaid et al. 2009");
}

}  // namespace

DeformationChoice::DeformationChoice(FaceModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      table_(new QComboBox(this)),
      open_(new QToolButton(this)),
      strength_(new ValueSlider(this)),
      percent_(new SignedWholeBox(this)),
      blend_(new QCheckBox(tr("Blend regions"), this)) {
  describeControls();
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(table_);
  row->addWidget(open_);
  row->addSpacing(10);
  row->addWidget(new QLabel(tr("Strength"), this));
  row->addWidget(strength_, 1);
  row->addWidget(percent_);
  row->addWidget(blend_);
  connectControls();
  follow();
}

void DeformationChoice::describeControls() {
  table_->setObjectName("deformationTable");
  table_->setAccessibleName(tr("Facial deformation table"));
  table_->setToolTip(
      tr("The table that bends the face: 16 regions with a<sub>1</sub> .. b<sub>6</sub> each, in pupil units; "
         "files can be dropped on this dock"));
  table_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  table_->setMinimumContentsLength(9);
  table_->addItem(tr("None"), QString());
  for (const std::string& name : tableNames()) {
    table_->addItem(capitalised(name), QString::fromStdString(name));
    table_->setItemData(table_->count() - 1, origin(*namedTable(name)), Qt::ToolTipRole);
  }
  open_->setObjectName("deformationOpen");
  open_->setText(tr("Open..."));
  open_->setToolTip(tr("A table from a file (.csv, or packed), as <i>mien fdt</i> and Save write them"));
  open_->setFocusPolicy(Qt::TabFocus);
  strength_->setObjectName("deformationStrength");
  strength_->setMinimumWidth(40);
  strength_->setRange(-mostPercent, mostPercent);
  strength_->setPageStep(10);
  strength_->setDoubleClickResets(true);
  strength_->setAccessibleName(tr("Strength of the deformation"));
  percent_->setObjectName("deformationPercent");
  percent_->setRange(-mostPercent, mostPercent);
  percent_->setSuffix(" %");
  percent_->setAlignment(Qt::AlignRight);
  percent_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  percent_->setAccessibleName(strength_->accessibleName());
  for (QWidget* widget : std::initializer_list<QWidget*>{strength_, percent_})
    widget->setToolTip(
        tr("Factor of all displacements, -200 % .. 200 %; 100 %: as the table says, 0 %: none (double click)"));
  percent_->setFixedWidth(percent_->fontMetrics().horizontalAdvance(withRealMinus("-200 %")) + 18);
  blend_->setObjectName("deformationBlend");
  blend_->setToolTip(
      tr("Smooth: neighbouring regions blend into each other. Off, hard: every point follows one region alone, as in "
         "the paper, and the skin may tear at their borders"));
}

void DeformationChoice::connectControls() {
  connect(table_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    const std::string table = table_->currentData().toString().toStdString();
    model_->change([&](FaceState& state) { state.deformation.table = table; });
  });
  connect(open_, &QToolButton::clicked, this, [this] {
    const QString name = FileDialog::open(window(), tr("Open deformation table"),
                                          tr("Facial deformation tables (*.csv *.CSV *.fdt);;All files (*)"));
    if (!name.isEmpty()) open(name);
  });
  connect(strength_, &QSlider::valueChanged, this, &DeformationChoice::setPercent);
  connect(percent_, QOverload<int>::of(&QSpinBox::valueChanged), this, &DeformationChoice::setPercent);
  connect(blend_, &QCheckBox::toggled, this,
          [this](bool on) { model_->change([on](FaceState& state) { state.deformation.smooth = on; }); });
  connect(model_, &FaceModel::stateChanged, this, &DeformationChoice::follow);
}

void DeformationChoice::setPercent(int percent) {
  model_->change([percent](FaceState& state) { state.deformation.strength = percent / percentOfAll; });
}

bool DeformationChoice::open(const QString& fileName) {
  return model_->openDeformationTable(fileName);
}

int DeformationChoice::rowOf(const QString& table) {
  const int row = table_->findData(table);
  if (row >= 0) return row;
  table_->addItem(shortTableText(table.toStdString()), table);
  table_->setItemData(table_->count() - 1, QString::fromStdString(tableTitle(table.toStdString())), Qt::ToolTipRole);
  return table_->count() - 1;
}

void DeformationChoice::follow() {
  const FaceDeformation& chosen = model_->state().deformation;
  const QSignalBlocker quiet[] = {QSignalBlocker(table_), QSignalBlocker(strength_), QSignalBlocker(percent_),
                                  QSignalBlocker(blend_)};
  const int percent = static_cast<int>(std::lround(percentOfAll * chosen.strength));
  table_->setCurrentIndex(rowOf(QString::fromStdString(chosen.table)));
  strength_->setValue(percent);
  strength_->setShownValue(percent);
  percent_->setValue(percent);
  blend_->setChecked(chosen.smooth);
  for (QWidget* widget : std::initializer_list<QWidget*>{strength_, percent_, blend_})
    widget->setEnabled(!chosen.table.empty());
}

}  // namespace mien
