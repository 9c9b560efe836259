#pragma once

#include <string>

#include "DeformationTable.h"
#include "MienDeformationModule.h"

class vtkTable;

namespace mien {

/// A facial deformation table as a vtkTable of 16 rows: `region` (1 .. 16), `a1` .. `b6`, with deviations `a1_sd` ..
/// `b6_sd`, all double, and `displacement` (pupil units) where it is known.
MIENDEFORMATION_EXPORT void writeFDT(const DeformationTable& table, vtkTable* data);

/// @return nothing, or one sentence that names the column or row at fault
MIENDEFORMATION_EXPORT std::string readFDT(vtkTable* data, DeformationTable& table);

}  // namespace mien
