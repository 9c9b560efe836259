#include "BoundFace.h"

#include "AnimationData.h"
#include "Failure.h"
#include "FigureContext.h"

namespace mien {

FaceAnimator boundFace(FigureContext& context) {
  FaceState neutral = context.state();
  neutral.fapFile.clear();
  neutral.fapValues.clear();
  neutral.expressions.clear();
  AnimationTable table;
  FaceAnimator animator;
  std::string fault = readAnimationTable(neutral.animationTable, table);
  if (fault.empty()) fault = animator.bind(context.curves(neutral), table);
  if (!fault.empty()) throw FileFailure(fault);
  return animator;
}

}  // namespace mien
