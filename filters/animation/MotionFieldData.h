#pragma once

#include <string>

#include "MienAnimationModule.h"
#include "MotionField.h"

class vtkPointSet;
class vtkPolyData;

namespace mien {

/// Reads a motion field from VTK data.
///
/// @param vectors  output of vtkMotionVectorFilter; with `Normals` its vectors on the back can be told
/// @param mesh     the surface whose points the vectors start from; a grid's closing column is left out, its
///                 `TextureCoordinates` (v / 2 pi, 1 - u) give u and v, its cell array `PatchId` the patches
/// @param drawn    the surface drawn under the vectors, such as `mesh` or the same face on a finer grid; its cell array
///                 `PatchId` gives the seams. Hidden cells are left out.
/// @param turnedBack  whether the vectors are without the rotation of the head that `drawn` knows
/// @return nothing, or one sentence that says what is wrong; the field is then as it was
MIENANIMATION_EXPORT std::string readMotionField(vtkPolyData* vectors, vtkPointSet* mesh, vtkPointSet* drawn,
                                                 bool turnedBack, MotionField& field);

}  // namespace mien
