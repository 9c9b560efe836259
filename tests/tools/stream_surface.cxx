/// Streams a face surface that is larger than memory through pieces and says how much memory that took; in one piece,
/// how much a surface takes beside its arrays.
///
/// usage: stream_surface ROWS COLUMNS PIECES MEGABYTES [SCHEME]; exit code 1 when points are missing or more memory was
/// in use.
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "vtkBoundaryCurveReader.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace {

struct Sums {
  long long cells = 0, hidden = 0;
  double area = 0.0;  // mm^2
};

/// Half the length of the diagonals' vector product: the area of a flat cell.
double cellArea(vtkStructuredGrid* grid, vtkIdType corner, int columns) {
  double p[4][3], a[3], b[3];
  const vtkIdType ids[4] = {corner, corner + 1, corner + columns + 1, corner + columns};
  for (int i = 0; i < 4; ++i) grid->GetPoint(ids[i], p[i]);
  for (int i = 0; i < 3; ++i) {
    a[i] = p[2][i] - p[0][i];
    b[i] = p[3][i] - p[1][i];
  }
  return 0.5 * std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
}

void addPiece(vtkStructuredGrid* grid, Sums& sums) {
  int size[3];
  grid->GetDimensions(size);
  for (int row = 0; row + 1 < size[1]; ++row)
    for (int column = 0; column + 1 < size[0]; ++column) {
      ++sums.cells;
      sums.area += cellArea(grid, static_cast<vtkIdType>(row) * size[0] + column, size[0]);
    }
  if (vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray())
    for (vtkIdType cell = 0; cell < ghosts->GetNumberOfTuples(); ++cell) sums.hidden += ghosts->GetValue(cell) != 0;
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024.0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) return std::fprintf(stderr, "usage: stream_surface ROWS COLUMNS PIECES MEGABYTES [SCHEME]\n"), 2;
  const int rows = std::atoi(arguments[1]), columns = std::atoi(arguments[2]), pieces = std::atoi(arguments[3]);
  vtkNew<vtkBoundaryCurveReader> generic;
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputConnection(generic->GetOutputPort());
  if (count > 5) face->SetScheme(arguments[5]);
  face->Update();  // what the libraries need at first is there before anything is measured
  face->SetResolution(rows, columns);
  Sums sums;
  double arrays = 0.0;  // MB of the largest piece
  const double before = peakMegabytes();
  for (int piece = 0; piece < pieces; ++piece) {
    face->UpdatePiece(piece, pieces, 0);
    addPiece(face->GetOutput(), sums);
    arrays = std::max(arrays, face->GetOutput()->GetActualMemorySize() / 1024.0);
  }
  std::printf("%lld cells, %lld of them hidden, %.3f mm^2, at most %.0f MB in use\n", sums.cells, sums.hidden,
              sums.area, peakMegabytes());
  std::printf("%.1f MB of it before the surface; the rest is %.2f times the %.1f MB of a piece's arrays\n", before,
              (peakMegabytes() - before) / arrays, arrays);
  const bool all = sums.cells == static_cast<long long>(rows - 1) * columns;
  return all && peakMegabytes() <= std::atof(arguments[4]) ? 0 : 1;
}
