#include "SurfaceTable.h"

#include <cmath>

#include "CsvText.h"
#include "FaceLayout.h"
#include "OutputFile.h"
#include "SurfaceFile.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr double seamTolerance = 1e-9;
const char* const header = "patch,u,v,x,y,z\n";

void appendRow(int patch, double u, int row, vtkStructuredGrid* grid, std::string& text) {
  int size[3];
  grid->GetDimensions(size);
  const std::string begin = std::to_string(patch) + "," + shortestText(u) + ",";
  for (int column = 0; column + 1 < size[0]; ++column) {
    double point[3];
    grid->GetPoint(static_cast<vtkIdType>(row) * size[0] + column, point);
    text += begin + shortestText(2.0 * M_PI * column / (size[0] - 1)) + coordinatesEndingLine(point);
  }
}

/// Whether the patch below begins where this row ends. Below the mouth it has a row of its own.
bool isSeam(const FaceRow& row, const FaceRow& next) {
  return std::abs(row.u - 1.0) < seamTolerance && next.patch == row.patch + 1 && next.u > seamTolerance;
}

}  // namespace

bool isTable(const std::string& name) {
  return fileEnding(name) == "csv";
}

void requireSurfaceOrTable(const std::string& name) {
  std::vector<std::string> endings = surfaceEndings();
  endings.push_back("csv");
  requireEnding(name, endings);
}

std::string faceTable(const RowLayout& layout, vtkStructuredGrid* grid) {
  std::string text = header;
  const auto& rows = layout.rows();
  for (int row = 0; row < static_cast<int>(rows.size()); ++row) {
    appendRow(rows[row].patch, rows[row].u, row, grid, text);
    if (row + 1 < static_cast<int>(rows.size()) && isSeam(rows[row], rows[row + 1]))
      appendRow(rows[row].patch + 1, 0.0, row, grid, text);
  }
  return text;
}

std::string patchTable(vtkStructuredGrid* grid) {
  std::string text = header;
  int size[3];
  grid->GetDimensions(size);
  for (int row = 0; row < size[1]; ++row) appendRow(0, static_cast<double>(row) / (size[1] - 1), row, grid, text);
  return text;
}

}  // namespace mien
