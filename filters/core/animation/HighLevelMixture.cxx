#include "HighLevelMixture.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace mien {

namespace {

/// A viseme or an expression, 0 for none, and how much of it a frame has.
struct Selection {
  double selected, weight;
};

using Selections = std::vector<Selection>;

/// A viseme that is none shares the weight of a frame with the other; it counts as one.
Selections selectionsOf(const Viseme& viseme) {
  return {{viseme.select1, viseme.blend}, {viseme.select2, FAPFrame::fullWeight - viseme.blend}};
}

Selections selectionsOf(const Expression& expression) {
  Selections selections;
  if (expression.select1 != 0.0) selections.push_back({expression.select1, expression.intensity1});
  if (expression.select2 != 0.0) selections.push_back({expression.select2, expression.intensity2});
  return selections;
}

void add(const Selections& part, double share, Selections& sum) {
  for (const Selection& one : part) {
    const auto known = std::find_if(sum.begin(), sum.end(), [&](auto& s) { return s.selected == one.selected; });
    if (known == sum.end())
      sum.push_back({one.selected, share * one.weight});
    else
      known->weight += share * one.weight;
  }
}

/// The mixture as the two selections a frame has room for, nothing where it needs more.
std::optional<Selections> mixture(const Selections& before, const Selections& after, double weight) {
  Selections sum;
  add(before, 1.0 - weight, sum);
  add(after, weight, sum);
  const auto isUnused = [](const Selection& one) { return one.weight == 0.0; };
  if (sum.size() > 2) sum.erase(std::remove_if(sum.begin(), sum.end(), isUnused), sum.end());
  if (sum.size() > 2) return std::nullopt;
  std::stable_partition(sum.begin(), sum.end(), [](const Selection& one) { return one.selected != 0.0; });
  sum.resize(2, {0.0, 0.0});
  return sum;
}

}  // namespace

Viseme mixture(const Viseme& before, const Viseme& after, double weight) {
  const auto mixed = mixture(selectionsOf(before), selectionsOf(after), weight);
  if (!mixed || before.definition != after.definition || mixed->front().selected == 0.0) return before;
  const Selection &first = mixed->front(), &second = mixed->back();
  return {first.selected, second.selected, first.weight, before.definition};
}

Expression mixture(const Expression& before, const Expression& after, double weight) {
  const auto mixed = mixture(selectionsOf(before), selectionsOf(after), weight);
  if (!mixed || before.definition != after.definition || before.initialFace != after.initialFace) return before;
  const Selection &first = mixed->front(), &second = mixed->back();
  return {first.selected, first.weight, second.selected, second.weight, before.initialFace, before.definition};
}

}  // namespace mien
