#pragma once

#include "FAPFrame.h"

namespace mien {

/// Calls visit(column name, value) for the fields of FAP 1 and 2, in the order of the file; Frame is FAPFrame or const.
template <typename Frame, typename Visitor>
void visitHighLevelFields(Frame& frame, Visitor&& visit) {
  visit("FAP1_viseme_select1", frame.viseme.select1);
  visit("FAP1_viseme_select2", frame.viseme.select2);
  visit("FAP1_viseme_blend", frame.viseme.blend);
  visit("FAP1_viseme_def", frame.viseme.definition);
  visit("FAP2_expression_select1", frame.expression.select1);
  visit("FAP2_expression_intensity1", frame.expression.intensity1);
  visit("FAP2_expression_select2", frame.expression.select2);
  visit("FAP2_expression_intensity2", frame.expression.intensity2);
  visit("FAP2_expression_init_face", frame.expression.initialFace);
  visit("FAP2_expression_def", frame.expression.definition);
}

constexpr int visemeFields = 4, highLevelFields = 10;  ///< fields of FAP 1, and of FAP 1 and 2

}  // namespace mien
