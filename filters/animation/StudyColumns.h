#pragma once

#include <string>
#include <vector>

class vtkTable;

namespace mien {

struct Study;

/// Makes a VTK table of the cells of a study's rows: the columns that vtkFaceStudySource names.
/// @param rows  cells as StudyTable::cellsOf() gives them
void writeStudyColumns(const Study& study, const std::vector<std::vector<std::string>>& rows, vtkTable* table);

}  // namespace mien
