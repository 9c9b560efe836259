#include "SurfacePanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "FaceModel.h"
#include "FaceScheme.h"
#include "SignedBox.h"

namespace mien {

namespace {

constexpr double leastSmoothing = 0.001;
constexpr int mostRows = 2000, mostColumns = 2000;  // what a picture can use; the state allows more

/// Each says what the first control of its row does.
void explainLabels(const QFormLayout& form) {
  for (int row = 0; row < form.rowCount(); ++row) {
    QLayoutItem* field = form.itemAt(row, QFormLayout::FieldRole);
    const QWidget* first = field->layout() ? field->layout()->itemAt(0)->widget() : field->widget();
    form.itemAt(row, QFormLayout::LabelRole)->widget()->setToolTip(first->toolTip());
  }
}

}  // namespace

SurfacePanel::SurfacePanel(FaceModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      scheme_(new QComboBox(this)),
      smoothing_(new SignedNumberBox(this)),
      modes_(new SignedWholeBox(this)),
      rows_(new SignedWholeBox(this)),
      columns_(new SignedWholeBox(this)),
      remainder_(new QCheckBox(tr("Remainder"), this)) {
  setObjectName("surfacePanel");
  auto* form = new QFormLayout(this);
  form->setContentsMargins(8, 2, 8, 8);
  form->setVerticalSpacing(6);
  addScheme(form);
  addSmoothing(form);
  addModes(form);
  addResolution(form);
  explainLabels(*form);
  connect(model_, &FaceModel::stateChanged, this, &SurfacePanel::follow);
  follow();
}

void SurfacePanel::addScheme(QFormLayout* form) {
  scheme_->setObjectName("surfaceScheme");
  scheme_->setToolTip(tr("How a patch meets its four curves"));
  for (const FaceScheme& scheme : faceSchemes()) {
    scheme_->addItem(QString::fromStdString(scheme.name));
    scheme_->setItemData(scheme_->count() - 1, QString::fromStdString(scheme.description), Qt::ToolTipRole);
  }
  connect(scheme_, &QComboBox::currentTextChanged, this, [this](const QString& name) {
    model_->change([&](FaceState& state) { state.surface.scheme = name.toStdString(); });
  });
  form->addRow(tr("Scheme"), scheme_);
}

void SurfacePanel::addSmoothing(QFormLayout* form) {
  smoothing_->setObjectName("surfaceSmoothing");
  smoothing_->setToolTip(tr("The smoothing parameter <i>a</i> of the PDE, for all patches (no unit; 1 in the paper)"));
  smoothing_->setDecimals(3);
  smoothing_->setRange(leastSmoothing, FaceSurfaceOptions::largestSmoothing);
  smoothing_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  smoothing_->setKeyboardTracking(false);
  connect(smoothing_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double a) { model_->change([a](FaceState& state) { state.surface.smoothing.fill(a); }); });
  form->addRow(tr("Smoothing a"), smoothing_);
}

void SurfacePanel::addModes(QFormLayout* form) {
  modes_->setObjectName("surfaceModes");
  modes_->setAccessibleName(tr("Modes N"));
  modes_->setToolTip(tr("N, how many Fourier modes are solved exactly (5 in the paper)"));
  modes_->setRange(0, model_->pointsPerCurve() / 2);
  modes_->setKeyboardTracking(false);
  remainder_->setObjectName("surfaceRemainder");
  remainder_->setToolTip(
      tr("Whether all harmonics above N follow as one remainder, so that the surface meets its curves"));
  connect(modes_, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int modes) { model_->change([modes](FaceState& state) { state.surface.modes = modes; }); });
  connect(remainder_, &QCheckBox::toggled, this,
          [this](bool on) { model_->change([on](FaceState& state) { state.surface.remainder = on; }); });
  auto* row = new QHBoxLayout;
  row->addWidget(modes_, 1);
  row->addWidget(remainder_);
  form->addRow(tr("Modes N"), row);
}

void SurfacePanel::addResolution(QFormLayout* form) {
  rows_->setObjectName("surfaceRows");
  rows_->setAccessibleName(tr("Rows of the mesh"));
  rows_->setToolTip(tr("Rows of the mesh, from the top of the head down"));
  rows_->setRange(11, mostRows);
  columns_->setObjectName("surfaceColumns");
  columns_->setAccessibleName(tr("Columns of the mesh"));
  columns_->setToolTip(tr("Columns of the mesh, around the head"));
  columns_->setRange(FaceState::smallestColumns, mostColumns);
  for (QSpinBox* box : {rows_, columns_}) {
    box->setKeyboardTracking(false);
    connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, [this] {
      model_->change([this](FaceState& state) {
        state.rows = rows_->value();
        state.columns = columns_->value();
      });
    });
  }
  auto* reset = new QPushButton(tr("Defaults"), this);
  reset->setObjectName("surfaceReset");
  reset->setToolTip(tr("Scheme, a, N and mesh as at the start"));
  connect(reset, &QPushButton::clicked, this, [this] {
    model_->change([](FaceState& state) {
      const FaceState start;
      state.surface = start.surface;
      state.rows = start.rows;
      state.columns = start.columns;
    });
  });
  auto* row = new QHBoxLayout;
  row->addWidget(rows_, 1);
  row->addWidget(new QLabel("\u00d7", this));
  row->addWidget(columns_, 1);
  row->addWidget(reset);
  form->addRow(tr("Mesh"), row);
}

void SurfacePanel::follow() {
  const FaceState& state = model_->state();
  const QSignalBlocker quiet[] = {QSignalBlocker(scheme_), QSignalBlocker(smoothing_), QSignalBlocker(modes_),
                                  QSignalBlocker(rows_),   QSignalBlocker(columns_),   QSignalBlocker(remainder_)};
  scheme_->setCurrentText(QString::fromStdString(state.surface.scheme));
  smoothing_->setValue(state.surface.smoothing.front());
  modes_->setValue(state.surface.modes);
  remainder_->setChecked(state.surface.remainder);
  rows_->setValue(state.rows);
  columns_->setValue(state.columns);
}

}  // namespace mien
