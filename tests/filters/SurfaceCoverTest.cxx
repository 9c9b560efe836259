#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "ComparedSurfaces.h"
#include "CoveredParts.h"
#include "SurfaceMesh.h"
#include "vtkAppendPolyData.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

TEST(SurfaceCover, OnlyWhatTheOtherSurfaceCoversCounts) {
  Comparison planes(plane(10.0, 3.5, 20), plane(20.0, 1.0, 40));  // of the larger one a quarter is covered
  planes.filter->Update();
  EXPECT_GT(planes.filter->GetMaximumDistance(1), 14.0);
  auto* reference = vtkPolyData::SafeDownCast(planes.filter->GetOutputDataObject(1));
  EXPECT_EQ(reference->GetPointData()->GetArray("Covered"), nullptr);
  planes.filter->CoveredOnlyOn();
  planes.filter->Update();
  EXPECT_EQ(planes.errors.count(), 0);
  EXPECT_NEAR(planes.filter->GetMaximumDistance(1), 2.5, 1e-12);
  EXPECT_NEAR(planes.filter->GetRMSDistance(1), 2.5, 1e-12);
  EXPECT_NEAR(planes.filter->GetRMSDistance(0), 2.5, 1e-12);
  auto* table = vtkTable::SafeDownCast(planes.filter->GetOutputDataObject(2));
  EXPECT_EQ(table->GetValueByName(0, "points").ToInt(), 21 * 21);
  EXPECT_EQ(table->GetValueByName(1, "points").ToInt(), 19 * 19) << "points right below the rim lie on it";
  vtkDataArray* covered = reference->GetPointData()->GetArray("Covered");
  ASSERT_NE(covered, nullptr);
  EXPECT_EQ(planes.distances(1)->GetNumberOfTuples(), 41 * 41) << "the array has all points";
  for (vtkIdType i = 0; i < reference->GetNumberOfPoints(); ++i) {
    const double* p = reference->GetPoint(i);
    EXPECT_EQ(covered->GetTuple1(i) > 0.0, std::abs(p[0]) < 9.9 && std::abs(p[1]) < 9.9) << p[0] << " " << p[1];
  }
}

TEST(SurfaceCover, TheSeamOfAClosedGridIsNoRim) {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputConnection(curves->GetOutputPort());
  vtkNew<vtkSurfaceDistanceFilter> filter;
  filter->SetInputConnection(face->GetOutputPort());
  filter->SetReferenceConnection(face->GetOutputPort());
  filter->CoveredOnlyOn();
  filter->Update();
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* covered = surface->GetPointData()->GetArray("Covered");
  double bounds[6];
  surface->GetBounds(bounds);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    if (covered->GetTuple1(i) == 0.0) {  // the first and the last curve alone, not the line at the back where v is 0
      const double y = surface->GetPoint(i)[1];
      EXPECT_TRUE(y > bounds[3] - 45.0 || y < bounds[2] + 45.0) << i << ": " << y;
    }
  EXPECT_GT(table->GetValueByName(0, "points").ToInt(), surface->GetNumberOfPoints() - 2 * 41 - 41);
}

TEST(SurfaceCover, SurfacesThatDoNotCoverEachOtherAreRefused) {
  Comparison planes(plane(10.0, 3.5, 7), plane(10.0, 1.0, 5));
  planes.filter->CoveredOnlyOn();
  const auto apart = plane(10.0, 1.0, 5);
  for (vtkIdType i = 0; i < apart->GetNumberOfPoints(); ++i)
    apart->GetPoints()->SetPoint(i, apart->GetPoint(i)[0] + 100.0, apart->GetPoint(i)[1], 1.0);
  planes.filter->SetReferenceData(apart);
  planes.filter->Update();
  EXPECT_NE(planes.errors.first().find("no point of the surface is covered by the reference mesh"), std::string::npos)
      << planes.errors.first();
  EXPECT_EQ(planes.filter->GetOutput()->GetNumberOfPoints(), 0);
}

namespace {

/// A plane of resolution x resolution cells with cover and distances; `isCovered` is told x and y, from -20 to 20.
vtkSmartPointer<vtkPolyData> coveredPlane(int resolution, const std::function<bool(const double*)>& isCovered) {
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(plane(20.0, 1.0, resolution));
  vtkNew<vtkUnsignedCharArray> covered;
  vtkNew<vtkDoubleArray> distances;
  covered->SetName("Covered");
  distances->SetName("Distance");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    covered->InsertNextValue(isCovered(surface->GetPoint(i)));
    distances->InsertNextValue(3.0);
  }
  surface->GetPointData()->AddArray(covered);
  surface->GetPointData()->AddArray(distances);
  return surface;
}

/// Every triangle with corners of its own.
vtkSmartPointer<vtkPolyData> soupOf(vtkPolyData* surface) {
  const auto triangles = mien::trianglesOf(surface);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const auto soup = vtkSmartPointer<vtkPolyData>::New();
  soup->GetPointData()->CopyAllocate(surface->GetPointData());
  const mien::TriangleMesh mesh = mien::meshOf(triangles);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    cells->InsertNextCell(3);
    for (int i = 0; i < 3; ++i) {
      const int corner = mesh.triangles(t, i);
      const vtkIdType copy = points->InsertNextPoint(triangles->GetPoint(corner));
      soup->GetPointData()->CopyData(surface->GetPointData(), corner, copy);
      cells->InsertCellPoint(copy);
    }
  }
  soup->SetPoints(points);
  soup->SetPolys(cells);
  return soup;
}

/// Of all triangles, and of those whose corners all have a distance (mm2).
std::array<double, 2> areas(vtkPolyData* surface) {
  const auto triangles = mien::trianglesOf(surface);
  const mien::TriangleMesh mesh = mien::meshOf(triangles);
  vtkDataArray* distances = surface->GetPointData()->GetArray("Distance");  // of the same points
  std::array<double, 2> sums = {0.0, 0.0};
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int i) { return Eigen::Vector3d(mesh.vertices.row(mesh.triangles(t, i))); };
    const double area = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    sums[0] += area;
    if (std::isfinite(distances->GetTuple1(mesh.triangles(t, 0)))) sums[1] += area;
  }
  return sums;
}

bool isInside(const double* p) {
  return std::hypot(p[0], p[1]) < 12.3;
}

}  // namespace

/// As STL files are: the same as when its triangles share their corners.
TEST(SurfaceCover, TrianglesWithCornersOfTheirOwnAreCutAsWhatTheyLookLike) {
  const auto surface = coveredPlane(40, isInside);
  surface->SetPolys(mien::trianglesOf(surface)->GetPolys());
  const auto soup = soupOf(surface);
  ASSERT_EQ(soup->GetNumberOfPoints(), 3 * 2 * 40 * 40);
  const auto [all, counted] = areas(mien::coveredApart(surface));
  const auto [allOfSoup, countedOfSoup] = areas(mien::coveredApart(soup));
  EXPECT_NEAR(all, 1600.0, 1e-9);
  EXPECT_NEAR(allOfSoup, 1600.0, 1e-9);
  EXPECT_NEAR(counted, M_PI * 12.3 * 12.3, 48.0) << "means draw a circle in, here by 0.6 mm";
  EXPECT_NEAR(countedOfSoup, counted, 1e-4);
}

/// An eye or a lash is less than 1 % of a head, but nothing is around it: it has a colour where it is covered alone.
/// One that is covered at a rim counts as the rest of it.
TEST(SurfaceCover, LoosePartsCountAsThemselves) {
  const auto skin = coveredPlane(100, isInside);
  struct Loose {
    double coveredBelow;  // x
    double counted;       // mm2
  };
  for (const Loose& wanted : {Loose{-30.0, 0.0}, Loose{-19.0, 0.0}, Loose{19.0, 1600.0}, Loose{30.0, 1600.0}}) {
    const auto eye = coveredPlane(5, [&](const double* p) { return p[0] < wanted.coveredBelow; });
    for (vtkIdType i = 0; i < eye->GetNumberOfPoints(); ++i)
      eye->GetPoints()->SetPoint(i, eye->GetPoint(i)[0] + 100.0, eye->GetPoint(i)[1], 1.0);
    vtkNew<vtkAppendPolyData> head;
    head->AddInputData(skin);
    head->AddInputData(eye);
    head->Update();
    const double alone = areas(mien::coveredApart(skin))[1];
    EXPECT_NEAR(areas(mien::coveredApart(head->GetOutput()))[1], alone + wanted.counted, 1e-4) << wanted.coveredBelow;
  }
}

TEST(SurfaceCover, CuttingTellsHowFarItIsAndEndsWhenItIsToldTo) {
  const auto surface = coveredPlane(60, isInside);
  std::vector<double> told;
  ASSERT_NE(mien::coveredApart(surface, [&](double done) { return told.push_back(done), true; }), nullptr);
  EXPECT_GT(told.size(), 60u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);
  for (size_t last = 1; last <= told.size(); ++last) {
    size_t asked = 0;
    EXPECT_EQ(mien::coveredApart(surface, [&](double) { return ++asked < last; }), nullptr) << last;
    EXPECT_LE(asked, last + 4) << "nothing of it goes on for long";
  }
}

/// A hole of 5 x 5 points in a covered plane is no part, and the edge is straight where a point on it changes to and
/// fro.
TEST(SurfaceCover, PartsThatAreNotCoveredAreCutOffAlongASmoothEdge) {
  const auto surface = coveredPlane(40, [](const double* p) {
    const double edge = std::lround(p[1]) % 2 == 0 ? 10.4 : 9.4;  // a zigzag about x = 9.9
    return p[0] < edge && std::max(std::abs(p[0]), std::abs(p[1])) > 2.5;
  });
  const auto cut = mien::coveredApart(surface);
  vtkDataArray* cutDistances = cut->GetPointData()->GetArray("Distance");
  double low = 1e9, high = -1e9;
  for (vtkIdType i = 0; i < cut->GetNumberOfPoints(); ++i) {
    const double* p = cut->GetPoint(i);
    if (std::isfinite(cutDistances->GetTuple1(i))) {
      EXPECT_NEAR(cutDistances->GetTuple1(i), 3.0, 1e-12);
      if (p[0] > 8.0 && std::abs(p[1]) < 15.0 && p[0] > high) high = p[0];
    } else {
      low = std::min(low, std::abs(p[1]) < 15.0 ? p[0] : low);
    }
  }
  EXPECT_NEAR(low, 9.9, 0.4);
  EXPECT_NEAR(high, 9.9, 0.4);
  EXPECT_GT(cut->GetNumberOfPoints(), surface->GetNumberOfPoints());
  surface->GetPointData()->GetArray("Covered")->Fill(1.0);
  EXPECT_EQ(mien::coveredApart(surface), surface);
}
