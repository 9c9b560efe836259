#include "HighLevelFAPs.h"

namespace mien {

namespace {

/// Clears the selection when the library has it, or when it is none.
void addSelected(const ExpressionLibrary& library, double& select, double weight, bool define, FAPFrame& frame) {
  if (select == 0.0) return;
  const ExpressionProfile* profile = library.find(static_cast<int>(select));
  if (!profile) return;
  if (!define) library.add(profile->name, weight / FAPFrame::fullWeight, frame);
  select = 0.0;
}

}  // namespace

void resolveHighLevelFAPs(const ExpressionLibrary& visemes, const ExpressionLibrary& expressions, FAPFrame& frame) {
  Viseme& v = frame.viseme;
  addSelected(visemes, v.select1, v.blend, v.definition != 0.0, frame);
  addSelected(visemes, v.select2, FAPFrame::fullWeight - v.blend, v.definition != 0.0, frame);
  Expression& e = frame.expression;
  addSelected(expressions, e.select1, e.intensity1, e.definition != 0.0, frame);
  addSelected(expressions, e.select2, e.intensity2, e.definition != 0.0, frame);
}

}  // namespace mien
