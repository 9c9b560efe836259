#include "FAPPanel.h"

#include "FAPRow.h"
#include "FAPTable.h"
#include "FaceModel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

namespace mien {

namespace {

/// The groups of the standard that the 22 FAPs come from, from the top of the face down.
constexpr int brows = 4, eyes = 3, cheeks = 5, nose = 9, mouth = 8;

/// A missing value is 0, so that a face with all sliders at rest equals the neutral one.
void setFAP(FaceState& state, int fap, double value) {
  if (value == 0.0)
    state.fapValues.erase(fap);
  else
    state.fapValues[fap] = value;
}

}  // namespace

FAPPanel::FAPPanel(FaceModel* model, QWidget* parent)
    : QWidget(parent), model_(model), tabs_(new QTabWidget(this)), mirror_(new QCheckBox(tr("&Mirror"), this)) {
  setObjectName("fapPanel");
  tabs_->setObjectName("fapTabs");
  tabs_->setDocumentMode(true);
  tabs_->tabBar()->setDrawBase(false);
  addTab(brows, tr("Brows"));
  addTab(eyes, tr("Eyes"));
  addTab(cheeks, tr("Cheeks"));
  addTab(nose, tr("Nose"));
  addTab(mouth, tr("Mouth"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 0, 8, 8);
  column->addWidget(tabs_, 1);
  column->addWidget(footer());
  connect(model_, &FaceModel::stateChanged, this, &FAPPanel::follow);
  connect(model_, &FaceModel::updated, this, &FAPPanel::follow);
  follow();
}

void FAPPanel::addTab(int group, const QString& title) {
  auto* page = new QWidget(tabs_);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2, 8, 2, 2);
  column->setSpacing(7);
  for (int number : paperSubset()) {
    const FAPDefinition& fap = fapDefinition(number);
    if (fap.group != group) continue;
    auto* row = new FAPRow(fap, model_->millimetresPerUnit(number), page);
    connect(row, &FAPRow::valueEdited, this, &FAPPanel::edit);
    rows_.insert(number, row);
    column->addWidget(row);
  }
  column->addStretch();
  tabs_->addTab(page, title);
}

QWidget* FAPPanel::footer() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  mirror_->setObjectName("fapMirror");
  mirror_->setToolTip(tr("Move both sides of the face together"));
  mirror_->setChecked(true);
  auto* reset = new QPushButton(tr("&Reset all FAPs"), bar);
  reset->setObjectName("fapResetAll");
  reset->setToolTip(tr("Every FAP back to 0; an expression and an animation stay"));
  connect(reset, &QPushButton::clicked, this, &FAPPanel::resetAll);
  row->addWidget(mirror_);
  row->addStretch();
  row->addWidget(reset);
  return bar;
}

void FAPPanel::edit(int fap, double value) {
  const FAPDefinition& definition = fapDefinition(fap);
  const bool both = mirror_->isChecked() && definition.mirrorPartner != fap;
  model_->change([&](FaceState& state) {
    setFAP(state, fap, value);
    if (both) setFAP(state, definition.mirrorPartner, definition.mirrorSign * value);
  });
}

void FAPPanel::resetAll() {
  model_->change([](FaceState& state) { state.fapValues.clear(); });
}

void FAPPanel::follow() {
  for (auto it = rows_.cbegin(); it != rows_.cend(); ++it) {
    const auto found = model_->state().fapValues.find(it.key());
    it.value()->setValue(found == model_->state().fapValues.end() ? 0.0 : found->second);
    it.value()->setShownValue(model_->shownFAP(it.key()));
  }
}

}  // namespace mien
