#include <gtest/gtest.h>

#include <cmath>

#include "ComparedSurfaces.h"
#include "CoveredParts.h"
#include "vtkBoundaryCurveReader.h"
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

/// A hole of 5 x 5 points in a covered plane is no part, and the edge is straight where a point on it changes to and
/// fro.
TEST(SurfaceCover, PartsThatAreNotCoveredAreCutOffAlongASmoothEdge) {
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(plane(20.0, 1.0, 40));
  vtkNew<vtkUnsignedCharArray> covered;
  vtkNew<vtkDoubleArray> distances;
  covered->SetName("Covered");
  distances->SetName("Distance");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    const double* p = surface->GetPoint(i);
    const double edge = std::lround(p[1]) % 2 == 0 ? 10.4 : 9.4;  // a zigzag about x = 9.9
    covered->InsertNextValue(p[0] < edge && std::max(std::abs(p[0]), std::abs(p[1])) > 2.5);
    distances->InsertNextValue(3.0);
  }
  surface->GetPointData()->AddArray(covered);
  surface->GetPointData()->AddArray(distances);
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
  covered->Fill(1.0);
  EXPECT_EQ(mien::coveredApart(surface), surface.Get());
}
