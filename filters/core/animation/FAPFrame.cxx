#include "FAPFrame.h"

#include <algorithm>

namespace mien {

bool FAPFrame::isNeutral() const {
  const bool noMovement =
      std::all_of(values_.begin() + firstLowLevel - 1, values_.end(), [](double v) { return v == 0.0; });
  const bool noViseme = viseme.select1 == 0.0 && viseme.select2 == 0.0;
  const bool noExpression = expression.select1 == 0.0 && expression.select2 == 0.0;
  return noMovement && noViseme && noExpression;
}

}  // namespace mien
