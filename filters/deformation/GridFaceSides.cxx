#include "GridFaceSides.h"

#include "GridSides.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace mien {

namespace {

constexpr int lidPatch = 2,
              lowerLipPatch = 7;  // P2 ends with C9, the upper lid, and C10, the lower; P7 begins below the lips

/// First row of cells of a patch or later ones; the number of rows when there is none.
int firstRow(vtkDataArray* patches, int rows, int columns, int patch) {
  int row = 0;
  while (row < rows && patches->GetComponent(vtkIdType(row) * columns, 0) < patch) ++row;
  return row;
}

void findOpening(vtkUnsignedCharArray* ghosts, int columns, GridSlits& slits) {
  const auto hidden = [&](int column) {
    return ghosts && ghosts->GetValue(vtkIdType(slits.upperLip) * columns + column) & vtkDataSetAttributes::HIDDENCELL;
  };
  int begin = 0, end = columns;
  while (begin < columns && !hidden(begin)) ++begin;
  while (end > begin && !hidden(end - 1)) --end;
  slits.openBegin = begin;
  slits.openEnd = end;
  if (begin >= end) slits.upperLip = -1;
}

}  // namespace

std::vector<FaceSide> gridFaceSides(vtkStructuredGrid* grid, const FacialRegions& regions, const FaceFrame& frame) {
  vtkDataArray* patches = grid->GetCellData()->GetArray("PatchId");
  int size[3];
  grid->GetDimensions(size);
  const int rows = size[1] - 1, columns = size[0] - 1;
  if (!patches || size[2] != 1 || rows < 1 || columns < 1 || patches->GetNumberOfTuples() != vtkIdType(rows) * columns)
    return {};
  GridSlits slits;
  slits.rows = size[1];
  slits.columns = size[0];
  const int slit = firstRow(patches, rows, columns, lowerLipPatch);
  if (slit < rows) {
    slits.upperLip = slit;
    findOpening(grid->GetCellGhostArray(), columns, slits);
  }
  const int begin = firstRow(patches, rows, columns, lidPatch), end = firstRow(patches, rows, columns, lidPatch + 1);
  if (begin < end && end < rows) {
    slits.upperLid = begin + (end - begin) * 2.0 / 3.0;
    slits.lowerLid = end;
  }
  const auto point = [&](int row, int column) { return frame.points[std::size_t(row) * size[0] + column].position; };
  return gridSides(slits, point, regions, frame.pupils);
}

}  // namespace mien
