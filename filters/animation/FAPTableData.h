#pragma once

#include <string>

#include "FAPFrame.h"
#include "MienAnimationModule.h"
#include "vtkType.h"

class vtkTable;

/// FAP frames as VTK data and as the mathematics sees them.
///
/// As vtkTable: a row per frame; double columns, in this order:
/// - `frame`: the frame number as written in the file;
/// - FAP 1: `FAP1_viseme_select1`, `FAP1_viseme_select2` (0 .. 14), `FAP1_viseme_blend` (0 .. 63),
///   `FAP1_viseme_def` (0 or 1);
/// - FAP 2: `FAP2_expression_select1`, `FAP2_expression_intensity1`, `FAP2_expression_select2`,
///   `FAP2_expression_intensity2` (selections 0 .. 6, intensities 0 .. 63), `FAP2_expression_init_face`,
///   `FAP2_expression_def` (0 or 1);
/// - `FAP3` .. `FAP68` in FAP units.
/// In the field data, when the frame comes from a reader: `AnimationLoad` (int), which differs between any two files.
namespace mien {

/// Reads one row; columns may be of any numeric type and order, and a column that is not there counts as 0.
/// @return nothing, or one sentence that names the column or row at fault; the frame is then as it was
MIENANIMATION_EXPORT std::string readFAPFrame(vtkTable* table, vtkIdType row, FAPFrame& frame);

/// Makes the table hold this frame alone, with all the columns named above.
MIENANIMATION_EXPORT void writeFAPFrame(const FAPFrame& frame, vtkTable* table);

/// Which loading of a file the frame comes from; 0 when the table does not say.
int readLoadNumber(vtkTable* table);
void writeLoadNumber(int number, vtkTable* table);  ///< as the field array `AnimationLoad`

}  // namespace mien
