#pragma once

#include "ExpressionLibrary.h"
#include "FAPFrame.h"

namespace mien {

/// Turns FAP 1 and FAP 2 of a frame into low-level values, which are added to those it has (ISO/IEC 14496-2):
///   viseme: shape(select1) b / 63 + shape(select2) (1 - b / 63), b the blend;
///   expression: shape(select1) intensity1 / 63 + shape(select2) intensity2 / 63.
/// With the flag `definition` the frame's own low-level values define the shape and nothing is added. What was
/// turned is cleared; a selection that the library does not have stays in the frame, so that it can be reported.
void resolveHighLevelFAPs(const ExpressionLibrary& visemes, const ExpressionLibrary& expressions, FAPFrame& frame);

}  // namespace mien
