#include "VisemePanel.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "FaceModel.h"
#include "VisemeRow.h"

namespace mien {

namespace {

constexpr double percentOfViseme = 100.0;

}  // namespace

VisemePanel::VisemePanel(FaceModel* model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName("visemePanel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(2);
  for (size_t i = 0; i < rows_.size(); ++i) {
    rows_[i] = new VisemeRow(static_cast<int>(i) + 1, this);
    column->addWidget(rows_[i]);
    connect(rows_[i], &VisemeRow::chosen, this, [this, i](const QString& name) { choose(i, name.toStdString()); });
    connect(rows_[i], &VisemeRow::percentEdited, this, [this, i](int percent) { setPercent(i, percent); });
  }
  connect(model_, &FaceModel::stateChanged, this, &VisemePanel::follow);
  follow();
}

/// Alone a viseme is whole; a second one shares with it half and half, as a mouth between the two. One that the other
/// row has already changes places.
void VisemePanel::choose(size_t row, const std::string& name) {
  const size_t other = 1 - row;
  if (!name.empty() && names_[other] == name) std::swap(names_[row], names_[other]);
  names_[row] = name;
  model_->change([&](FaceState& state) {
    const auto strength = [&](const std::string& viseme) {
      const auto found = state.visemes.find(viseme);
      return found == state.visemes.end() ? 1.0 : found->second;
    };
    std::map<std::string, double> chosen;
    for (const std::string& viseme : names_)
      if (!viseme.empty()) chosen[viseme] = strength(viseme);
    double sum = 0.0;
    for (const auto& viseme : chosen) sum += viseme.second;
    if (chosen.size() > 1 && sum > 1.0)
      for (auto& viseme : chosen) viseme.second = 0.5;
    state.visemes = chosen;
  });
  follow();
}

/// One of no strength stays in its row, while the state is that of a face without it.
void VisemePanel::setPercent(size_t row, int percent) {
  if (names_[row].empty()) return;
  slides_ = true;
  model_->change([&](FaceState& state) {
    if (percent == 0)
      state.visemes.erase(names_[row]);
    else
      state.visemes[names_[row]] = percent / percentOfViseme;
  });
  slides_ = false;
}

/// A viseme keeps its row; one that came from elsewhere takes a row whose own is at rest.
void VisemePanel::follow() {
  const auto& mixture = model_->state().visemes;
  const auto isAtRest = [&](const std::string& name) { return mixture.count(name) == 0; };
  for (const auto& viseme : mixture) {
    if (std::count(names_.begin(), names_.end(), viseme.first)) continue;
    const auto free = std::find_if(names_.begin(), names_.end(), isAtRest);
    if (free != names_.end()) *free = viseme.first;
  }
  if (mixture.empty() && !slides_) names_.fill({});
  for (size_t i = 0; i < rows_.size(); ++i) {
    const auto found = mixture.find(names_[i]);
    const double strength = found == mixture.end() ? 0.0 : found->second;
    rows_[i]->show(names_[i], static_cast<int>(std::lround(percentOfViseme * strength)));
  }
}

}  // namespace mien
