#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "FDTData.h"
#include "LandmarkTable.h"
#include "ReferenceData.h"
#include "TextFile.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkPupilNormalizeFilter.h"
#include "vtkTable.h"

/// A head of the reference data deformed by a table.
struct Head {
  vtkNew<vtkPLYReader> reader;
  vtkNew<vtkFDTDeformationFilter> filter;
  mien::LandmarkTable landmarks;
  double unit = 0.0;

  explicit Head(const std::string& name) {
    reader->SetFileName(referencePath("heads/" + name + ".ply").c_str());
    filter->SetInputConnection(reader->GetOutputPort());
    filter->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
    EXPECT_EQ(mien::parseLandmarks(readTextFile(referencePath("heads/landmarks68.csv")), landmarks), "");
    vtkNew<vtkPupilNormalizeFilter> pupils;
    pupils->SetInputConnection(reader->GetOutputPort());
    pupils->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
    pupils->Update();
    vtkDataArray* places = pupils->GetOutput()->GetFieldData()->GetArray("OriginalPupils");
    unit = 0.5 * std::hypot(places->GetComponent(0, 0) - places->GetComponent(1, 0),
                            places->GetComponent(0, 1) - places->GetComponent(1, 1));
  }

  void deform(const mien::DeformationTable& table, bool smooth = true) {
    vtkNew<vtkTable> data;
    mien::writeFDT(table, data);
    filter->SetTableData(data);
    filter->SetSmooth(smooth);
    filter->Update();
  }
  Eigen::Vector3d before(vtkIdType i) const { return Eigen::Vector3d(reader->GetOutput()->GetPoint(i)); }
  Eigen::Vector3d after(vtkIdType i) const { return Eigen::Vector3d(filter->GetOutput()->GetPoint(i)); }
  Eigen::Vector3d landmarkMove(int landmark) const {
    return (after(landmarks.vertices[landmark]) - before(landmarks.vertices[landmark])) / unit;
  }

  /// Calls function(ids) for each triangle, quads taken as two.
  template <class Function>
  void forTriangles(const Function& function) const {
    vtkNew<vtkIdList> ids;
    vtkCellArray* cells = reader->GetOutput()->GetPolys();
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
      cells->GetCellAtId(cell, ids);
      for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
        function(std::array<vtkIdType, 3>{ids->GetId(0), ids->GetId(k - 1), ids->GetId(k)});
    }
  }

  /// The same in front of z = 50 mm.
  template <class Function>
  void forFrontalTriangles(const Function& function) const {
    forTriangles([&](const std::array<vtkIdType, 3>& t) {
      if ((before(t[0]).z() + before(t[1]).z() + before(t[2]).z()) / 3.0 > 50.0) function(t);
    });
  }

  /// Triangles that are turned round.
  int flips(bool onlyInFront) const {
    int count = 0;
    forTriangles([&](const std::array<vtkIdType, 3>& t) {
      const auto normal = [&](auto point) {
        return (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).eval();
      };
      const Eigen::Vector3d a = normal([&](vtkIdType i) { return before(i); });
      const Eigen::Vector3d b = normal([&](vtkIdType i) { return after(i); });
      const double z = (before(t[0]).z() + before(t[1]).z() + before(t[2]).z()) / 3.0;
      count += a.dot(b) <= 0.0 && (!onlyInFront || z > 50.0);
    });
    return count;
  }

  /// The largest difference of the displacements along an edge, per its length; edges below 0.3 mm count as that long.
  double steepest() const {
    double largest = 0.0;
    forTriangles([&](const std::array<vtkIdType, 3>& t) {
      for (int k = 0; k < 3; ++k) {
        const vtkIdType a = t[k], b = t[(k + 1) % 3];
        const double length = std::max((before(a) - before(b)).norm(), 0.3);
        largest = std::max(largest, (after(a) - before(a) - after(b) + before(b)).norm() / length);
      }
    });
    return largest;
  }

  double largestMove() const {
    double largest = 0.0;
    for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
      largest = std::max(largest, (after(i) - before(i)).norm());
    return largest;
  }
};
