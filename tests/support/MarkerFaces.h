#pragma once

#include <cmath>
#include <vector>

#include "DefaultRegions.h"
#include "FDTData.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

/// The generic PDE face.
struct Face {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEFaceFilter> grid;

  Face() {
    grid->SetInputConnection(curves->GetOutputPort());
    grid->SetResolution(83, 80);
  }
};

/// Markers on a grid over a face whose pupils are 62 apart; `moved` bends them by a table.
inline vtkSmartPointer<vtkPolyData> markers(const mien::DeformationTable* table, double turn = 0.0) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkStringArray> names;
  names->SetName("marker");
  vtkNew<vtkIntArray> regions;
  regions->SetName("region");
  const mien::FacialRegions& map = mien::defaultRegions();
  const auto add = [&](const char* name, const Eigen::Vector2d& p, int region) {
    const double x = 31 * p.x() + 3, y = 31 * p.y() + 40;
    points->InsertNextPoint(std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, 80.0);
    names->InsertNextValue(name);
    regions->InsertNextValue(region);
  };
  add("pupil_left", {1.0, 0.0}, 0);
  add("pupil_right", {-1.0, 0.0}, 0);
  for (double y = -3.9; y < 1.9; y += 0.2)
    for (double x = -1.9; x < 2.0; x += 0.2) {
      const Eigen::Vector2d p(x, y);
      const int region = map.nearest(p);
      add("skin", table ? table->maps[region - 1].apply(p) : p, region);
    }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(names);
  data->GetPointData()->AddArray(regions);
  return data;
}

inline std::vector<double> coordinates(vtkPointSet* data) {
  std::vector<double> result;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    for (int k = 0; k < 3; ++k) result.push_back(data->GetPoint(i)[k]);
  return result;
}

inline vtkSmartPointer<vtkTable> tableOf(const mien::DeformationTable& table) {
  auto data = vtkSmartPointer<vtkTable>::New();
  mien::writeFDT(table, data);
  return data;
}
