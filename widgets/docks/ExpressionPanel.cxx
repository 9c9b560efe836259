#include "ExpressionPanel.h"

#include <QVBoxLayout>
#include <cmath>

#include "ExpressionRow.h"
#include "FaceModel.h"
#include "VisemePanel.h"
#include "vtkFAPAnimationFilter.h"

namespace mien {

namespace {

constexpr double percentOfAll = 100.0;

/// A missing expression is one of 0, so that a face with all sliders at rest equals the neutral one.
void setExpression(FaceState& state, const std::string& name, int percent) {
  if (percent == 0)
    state.expressions.erase(name);
  else
    state.expressions[name] = percent / percentOfAll;
}

}  // namespace

ExpressionPanel::ExpressionPanel(FaceModel* model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName("expressionPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 2, 8, 8);
  column->setSpacing(2);
  for (const std::string& name : vtkFAPAnimationFilter::GetExpressionNames()) addRow(QString::fromStdString(name));
  column->addWidget(new VisemePanel(model_, this));
  column->addStretch();
  connect(model_, &FaceModel::stateChanged, this, &ExpressionPanel::follow);
  follow();
}

void ExpressionPanel::addRow(const QString& name) {
  const std::string key = name.toStdString();
  auto* row =
      new ExpressionRow(name, QString::fromStdString(vtkFAPAnimationFilter::GetExpressionDefinition(key)), this);
  connect(row, &ExpressionRow::percentEdited, this,
          [this, key](int percent) { model_->change([&](FaceState& state) { setExpression(state, key, percent); }); });
  connect(row, &ExpressionRow::chosenAlone, this, [this, key](bool chosen) {
    model_->change([&](FaceState& state) {
      state.expressions.clear();
      if (chosen) state.expressions[key] = 1.0;
    });
    follow();
  });
  layout()->addWidget(row);
  rows_.insert(name, row);
}

void ExpressionPanel::follow() {
  const auto& mixture = model_->state().expressions;
  for (auto it = rows_.cbegin(); it != rows_.cend(); ++it) {
    const auto found = mixture.find(it.key().toStdString());
    it.value()->setPercent(found == mixture.end() ? 0 : static_cast<int>(std::lround(percentOfAll * found->second)));
  }
}

}  // namespace mien
