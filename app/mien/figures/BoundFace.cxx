#include "BoundFace.h"

#include "AnimationData.h"
#include "Failure.h"
#include "FigureContext.h"

namespace mien {

FaceAnimator boundFace(FigureContext& context) {
  AnimationTable table;
  FaceAnimator animator;
  std::string fault = readAnimationTable(context.state().animationTable, table);
  if (fault.empty()) fault = animator.bind(context.neutralFace(), table);
  if (!fault.empty()) throw FileFailure(fault);
  return animator;
}

}  // namespace mien
