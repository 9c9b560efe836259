#pragma once

#include "FaceSurface.h"
#include "HarmonicSplit.h"

namespace mien {

/// The Lebesgue constant of a face: how much a surface can at most exceed the data that it is made from.
///
/// The maximum of sum |U| over u, over all rates of the split and all patches. Only columns of values count, so that
/// the constant has no unit; shared derivatives are other data. The spline's slopes are no data of their own, they
/// follow from the curves: there the columns are those of all 29 curves.
/// @return infinity when the conditions determine no surface
double faceLebesgueConstant(const FaceSurfaceOptions& options, const HarmonicSplit& split);

}  // namespace mien
