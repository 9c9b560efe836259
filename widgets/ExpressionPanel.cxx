#include "ExpressionPanel.h"

#include "ValueSlider.h"
#include "FaceModel.h"
#include "vtkFAPAnimationFilter.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>

namespace mien {

namespace {

constexpr int buttonsInARow = 3;

}  // namespace

ExpressionPanel::ExpressionPanel(FaceModel* model, QWidget* parent)
    : QWidget(parent), model_(model), slider_(new ValueSlider(this)), percent_(new QSpinBox(this)) {
  setObjectName("expressionPanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 2, 8, 8);
  column->addWidget(buttons());
  column->addWidget(intensityRow());
  connect(model_, &FaceModel::stateChanged, this, &ExpressionPanel::follow);
  follow();
}

QWidget* ExpressionPanel::buttons() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (const std::string& expression : vtkFAPAnimationFilter::GetExpressionNames()) {
    const QString name = QString::fromStdString(expression);
    auto* button = new QPushButton(name.left(1).toUpper() + name.mid(1), box);
    button->setObjectName("expression_" + name);
    button->setCheckable(true);
    const QString definition = QString::fromStdString(vtkFAPAnimationFilter::GetExpressionDefinition(expression));
    button->setToolTip(tr("%1 Click again for the neutral face.").arg(definition));
    connect(button, &QPushButton::clicked, this, [this, name] { choose(name); });
    grid->addWidget(button, buttons_.size() / buttonsInARow, buttons_.size() % buttonsInARow);
    buttons_.insert(name, button);
  }
  return box;
}

QWidget* ExpressionPanel::intensityRow() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  slider_->setObjectName("expressionIntensity");
  slider_->setRange(0, 100);
  slider_->setPageStep(10);
  slider_->setAccessibleName(tr("Intensity of the expression"));
  percent_->setObjectName("expressionPercent");
  percent_->setRange(0, 100);
  percent_->setValue(100);
  percent_->setSuffix(" %");
  percent_->setAccessibleName(slider_->accessibleName());
  const auto setIntensity = [this](int value) {
    model_->change([value](FaceState& state) {
      for (auto& expression : state.expressions) expression.second = value / 100.0;
    });
  };
  connect(slider_, &QSlider::valueChanged, this, setIntensity);
  connect(percent_, QOverload<int>::of(&QSpinBox::valueChanged), this, setIntensity);
  row->addWidget(new QLabel(tr("Intensity"), box));
  row->addWidget(slider_, 1);
  row->addWidget(percent_);
  return box;
}

void ExpressionPanel::choose(const QString& name) {
  model_->change([&](FaceState& state) {
    const bool wasChosen = state.expressions.count(name.toStdString()) > 0;
    state.expressions.clear();
    if (!wasChosen) state.expressions[name.toStdString()] = percent_->value() / 100.0;
  });
  follow();
}

void ExpressionPanel::follow() {
  const FaceState& state = model_->state();
  const QSignalBlocker quietSlider(slider_), quietPercent(percent_);
  for (auto it = buttons_.cbegin(); it != buttons_.cend(); ++it)
    it.value()->setChecked(state.expressions.count(it.key().toStdString()) > 0);
  const double intensity = state.expressions.empty() ? percent_->value() / 100.0 : state.expressions.begin()->second;
  const int percent = static_cast<int>(std::lround(100.0 * intensity));
  slider_->setValue(percent);
  slider_->setShownValue(percent);
  percent_->setValue(percent);
  for (QWidget* widget : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(percent_)})
    widget->setEnabled(!state.expressions.empty());
}

}  // namespace mien
