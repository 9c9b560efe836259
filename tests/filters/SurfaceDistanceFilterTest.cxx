#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "ComparedSurfaces.h"
#include "ReferenceData.h"
#include "SurfaceDistance.h"
#include "SurfaceMesh.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceDistanceFilter.h"
#include "vtkTable.h"
#include "vtkTriangle.h"

TEST(SurfaceDistanceFilter, ShiftedPlanesAreExactlyApart) {
  Comparison planes(plane(10.0, 3.5, 7), plane(20.0, 1.0, 5));
  planes.filter->SetSigned(true);
  planes.filter->Update();
  EXPECT_EQ(planes.errors.count(), 0);
  EXPECT_NEAR(planes.filter->GetRMSDistance(0), 2.5, 1e-12);
  EXPECT_NEAR(planes.filter->GetMaximumDistance(0), 2.5, 1e-12);
  EXPECT_NEAR(planes.filter->GetMeanDistance(0), 2.5, 1e-12);
  double range[2];
  planes.distances()->GetRange(range);
  EXPECT_NEAR(range[0], 2.5, 1e-12);
  // The corners of the larger plane overhang by 10 mm both ways.
  EXPECT_NEAR(planes.filter->GetMaximumDistance(1), std::sqrt(200.0 + 6.25), 1e-12);
  planes.distances(1)->GetRange(range);
  EXPECT_LT(range[1], 0.0);
}

TEST(SurfaceDistanceFilter, VectorsLeadToTheNearestPoint) {
  Comparison planes(plane(10.0, 3.5, 7), plane(20.0, 1.0, 5));
  planes.filter->Update();
  const auto vectors = [&](int port) {
    return vtkPolyData::SafeDownCast(planes.filter->GetOutputDataObject(port))
        ->GetPointData()
        ->GetArray("DistanceVector");
  };
  EXPECT_EQ(vectors(0), nullptr);  // unless they are asked for
  planes.filter->GenerateVectorsOn();
  planes.filter->Update();
  EXPECT_EQ(planes.errors.count(), 0);
  for (int port : {0, 1}) {
    auto* surface = vtkPolyData::SafeDownCast(planes.filter->GetOutputDataObject(port));
    ASSERT_NE(vectors(port), nullptr);
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
      double p[3];
      surface->GetPoint(i, p);
      const double* v = vectors(port)->GetTuple3(i);
      const double edge = port == 0 ? 20.0 : 10.0;  // of the other plane
      EXPECT_NEAR(v[0], std::clamp(p[0], -edge, edge) - p[0], 1e-12);
      EXPECT_NEAR(v[1], std::clamp(p[1], -edge, edge) - p[1], 1e-12);
      EXPECT_NEAR(v[2], port == 0 ? -2.5 : 2.5, 1e-12);
      EXPECT_NEAR(std::hypot(v[0], v[1], v[2]), planes.distances(port)->GetTuple1(i), 1e-12);
    }
  }
}

TEST(SurfaceDistanceFilter, ConcentricSpheresAreTheDifferenceOfTheirRadiiApart) {
  Comparison spheres(sphere(12.0), sphere(10.0));
  spheres.filter->Update();
  EXPECT_NEAR(spheres.filter->GetRMSDistance(0), 2.0, 1e-9);  // the nearest point is the corner below
  EXPECT_NEAR(spheres.filter->GetMaximumDistance(0), 2.0, 1e-9);
  double error = 0.0;
  for (const int resolution : {32, 64, 128}) {  // facets of the outer sphere lie inside of it by O(h^2)
    Comparison finer(sphere(12.0, resolution), sphere(10.0, resolution));
    finer.filter->Update();
    const double now = std::abs(finer.filter->GetRMSDistance(1) - 2.0);
    if (error > 0.0) {
      EXPECT_NEAR(error / now, 4.0, 0.5) << resolution;
    }
    error = now;
  }
}

TEST(SurfaceDistanceFilter, MedianAndNinetyFivePercentCountAreaAndNotPoints) {
  constexpr double size = 10.0, rise = 4.0;
  const auto ramp = plane(size, 0.0, 200);  // its height is spread evenly over its area, its points are not
  for (vtkIdType i = 0; i < ramp->GetNumberOfPoints(); ++i) {
    double p[3];
    ramp->GetPoint(i, p);
    const double share = (p[0] / size + 1.0) / 2.0;
    ramp->GetPoints()->SetPoint(i, size * (2.0 * share * share - 1.0), p[1], rise * share * share);
  }
  Comparison ramps(ramp, plane(20.0, 0.0, 1));
  ramps.filter->Update();
  EXPECT_EQ(ramps.errors.count(), 0);
  EXPECT_NEAR(ramps.filter->GetMedianDistance(), 0.5 * rise, 0.01 * rise);  // of points it would be a quarter
  EXPECT_NEAR(ramps.filter->GetPercentile95Distance(), 0.95 * rise, 0.01 * rise);
  EXPECT_NEAR(ramps.filter->GetMaximumDistance(), rise, 1e-12);
  auto* table = vtkTable::SafeDownCast(ramps.filter->GetOutputDataObject(2));
  EXPECT_EQ(table->GetValueByName(0, "median_mm").ToDouble(), ramps.filter->GetMedianDistance());
  EXPECT_EQ(table->GetValueByName(0, "p95_mm").ToDouble(), ramps.filter->GetPercentile95Distance());
}

TEST(SurfaceDistanceFilter, SignsTellInsideFromOutside) {
  const auto ball = sphere(10.0, 12);
  const auto triangles = mien::trianglesOf(ball);
  const mien::SurfaceDistance distance(triangles);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-14.0, 14.0);
  for (int i = 0; i < 3000; ++i) {
    const double p[3] = {coordinate(random), coordinate(random), coordinate(random)};
    const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    if (radius > 10.0) {
      EXPECT_GT(distance(p, true), 0.0);
    } else if (radius < 9.3) {  // within every facet
      EXPECT_LT(distance(p, true), 0.0);
    }
  }
}

TEST(SurfaceDistanceFilter, FindsTheNearestPointThatSearchingAllTrianglesFinds) {
  const auto triangles = mien::trianglesOf(sphere(10.0, 20));
  const mien::SurfaceDistance distance(triangles);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-40.0, 40.0);
  for (int i = 0; i < 300; ++i) {
    double p[3] = {coordinate(random), coordinate(random), coordinate(random)}, closest[3], local[3], shares[3],
           squared = 0.0, best = 1e9;
    int part = 0;
    for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
      if (triangles->GetCell(cell)->EvaluatePosition(p, closest, part, local, squared, shares) >= 0)
        best = std::min(best, squared);
    EXPECT_NEAR(distance(p, false), std::sqrt(best), 1e-9);
  }
}

TEST(SurfaceDistanceFilter, WeightsWithAreaSoThatTriangulationDoesNotDecide) {
  // Half of the area is 1 mm, half 3 mm away; the far half has 100 times the cells.
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> surface;
  surface->AllocateExact(101, 4);
  const auto strip = [&](double x, double z, int cells) {
    for (int i = 0; i < cells; ++i) {
      const double begin = 10.0 * i / cells, end = 10.0 * (i + 1) / cells;
      vtkIdType ids[4];
      ids[0] = points->InsertNextPoint(x, begin, z);
      ids[1] = points->InsertNextPoint(x + 5.0, begin, z);
      ids[2] = points->InsertNextPoint(x + 5.0, end, z);
      ids[3] = points->InsertNextPoint(x, end, z);
      surface->InsertNextCell(VTK_QUAD, 4, ids);
    }
  };
  strip(-10.0, 1.0, 1);
  strip(5.0, 3.0, 100);
  surface->SetPoints(points);
  Comparison halves(surface, plane(100.0, 0.0, 3));
  halves.filter->Update();
  EXPECT_NEAR(halves.filter->GetMeanDistance(), 2.0, 1e-6);
  EXPECT_NEAR(halves.filter->GetRMSDistance(), std::sqrt(5.0), 1e-6);
  EXPECT_EQ(halves.filter->GetMaximumDistance(), 3.0);
  halves.filter->SetFrontalOnly(true);
  halves.filter->SetFrontalThreshold(2.0);
  halves.filter->Update();
  EXPECT_EQ(halves.filter->GetOutput()->GetNumberOfPoints(), 0);  // of the reference nothing is in front of 2 mm
  EXPECT_NE(halves.errors.first().find("z > 2 mm"), std::string::npos);
}

TEST(SurfaceDistanceFilter, TakesVisibleCellsOfAGridAndTurnsThemOutwards) {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputConnection(curves->GetOutputPort());
  vtkNew<vtkSurfaceDistanceFilter> filter;
  filter->SetInputConnection(face->GetOutputPort());
  filter->SetReferenceData(sphere(1.0));  // inside the head
  filter->SignedOn();
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPolys(), 0);
  EXPECT_LT(filter->GetOutput()->GetNumberOfPolys(), 55 * 40);
  double range[2];
  filter->GetOutput()->GetPointData()->GetArray("Distance")->GetRange(range);
  EXPECT_GT(range[0], 0.0);
  vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))->GetPointData()->GetArray("Distance")->GetRange(range);
  EXPECT_LT(range[1], 0.0);
  EXPECT_EQ(vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetNumberOfRows(), 2);
}

TEST(SurfaceDistanceFilter, ThreadsDoNotChangeTheNumbers) {
  const auto measured = [](int threads) {
    vtkSMPTools::Initialize(threads);
    Comparison spheres(sphere(12.0, 100), sphere(10.0, 60));
    spheres.filter->Update();
    return spheres.filter->GetRMSDistance();
  };
  const double one = measured(1), two = measured(2);
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(one, two);
}

TEST(SurfaceDistanceFilter, RefusesWhatIsNoSurface) {
  vtkNew<vtkPolyData> nothing;
  Comparison empty(sphere(1.0), nothing);
  empty.filter->Update();
  EXPECT_NE(empty.errors.first().find("reference mesh has no polygons"), std::string::npos);
  EXPECT_EQ(empty.filter->GetOutput()->GetNumberOfPoints(), 0);
  const auto broken = sphere(1.0);
  broken->GetPoints()->SetPoint(7, 0.0, std::nan(""), 0.0);
  Comparison notFinite(broken, sphere(1.0));
  notFinite.filter->Update();
  EXPECT_NE(notFinite.errors.first().find("point 7 of the surface"), std::string::npos);
}

// VTK's filters index with whatever ids a file holds: without a check these meshes end the process.
TEST(SurfaceDistanceFilter, RefusesCellsAndArraysThatDoNotFitThePoints) {
  const auto refused = [](const std::function<void(vtkPolyData*)>& damage, const char* word) {
    for (const int port : {0, 1}) {
      const auto damaged = sphere(1.0, 8);
      damage(damaged);
      Comparison comparison(port == 0 ? damaged : sphere(1.0, 8), port == 0 ? sphere(1.0, 8) : damaged);
      comparison.filter->SetLargestComponentOnly(true);
      comparison.filter->Update();
      const std::string name = port == 0 ? "the surface" : "the reference mesh";
      EXPECT_NE(comparison.errors.first().find(word), std::string::npos) << comparison.errors.first();
      EXPECT_NE(comparison.errors.first().find(name), std::string::npos) << comparison.errors.first();
      EXPECT_EQ(comparison.filter->GetOutput()->GetNumberOfPoints(), 0);
    }
  };
  const auto cellsOf = [](vtkIdType wrong) {
    vtkNew<vtkCellArray> cells;
    const vtkIdType ids[3] = {0, 1, wrong};
    cells->InsertNextCell(3, ids);
    return vtkSmartPointer<vtkCellArray>(cells);
  };
  refused([&](vtkPolyData* mesh) { mesh->SetPolys(cellsOf(mesh->GetNumberOfPoints())); }, "polygons");
  refused([&](vtkPolyData* mesh) { mesh->SetPolys(cellsOf(-1)); }, "uses point -1 of");
  refused([&](vtkPolyData* mesh) { mesh->SetStrips(cellsOf(1000000000000)); }, "strips");
  refused([&](vtkPolyData* mesh) { mesh->SetLines(cellsOf(-7)); }, "lines");
  refused([&](vtkPolyData* mesh) { mesh->GetPointData()->GetNormals()->SetNumberOfTuples(3); }, "has 3 values");
  refused(
      [&](vtkPolyData* mesh) {
        vtkNew<vtkDoubleArray> flat;
        flat->SetName("flat");
        flat->SetNumberOfComponents(1);
        flat->SetNumberOfTuples(mesh->GetNumberOfPoints());
        mesh->GetPointData()->SetNormals(nullptr);
        mesh->GetPointData()->AddArray(flat);
        mesh->GetPolys()->GetOffsetsArray()->SetTuple1(1, 100000.0);
      },
      "offsets");
}

TEST(SurfaceDistanceFilter, RefusesAMeshWithoutArea) {
  const auto flat = sphere(1.0, 8);
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i) flat->GetPoints()->SetPoint(i, 1.0 * i, 0.0, 0.0);
  Comparison comparison(sphere(1.0), flat);
  comparison.filter->Update();
  EXPECT_NE(comparison.errors.first().find("the reference mesh has no area"), std::string::npos)
      << comparison.errors.first();
}

TEST(SurfaceDistanceFilter, AnAbortedUpdateLeavesNoHalfOutput) {
  Comparison spheres(sphere(12.0, 200), sphere(10.0));
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  spheres.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  spheres.filter->Update();
  EXPECT_EQ(spheres.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(spheres.filter->GetRMSDistance(), 0.0);
}

// The figures of the generic face at 224 x 160, a = 1, N = 5, in front of z = 50 mm, against skin and eyeballs.
TEST(SurfaceDistanceFilter, TheGenericFaceLiesOnTheMeanHead) {
  MIEN_REQUIRE_REFERENCE("heads/mean_neutral.ply");
  vtkNew<vtkPLYReader> head;
  head->SetFileName(referencePath("heads/mean_neutral.ply").c_str());
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputConnection(curves->GetOutputPort());
  face->SetResolution(224, 160);
  vtkNew<vtkSurfaceDistanceFilter> filter;
  filter->SetInputConnection(face->GetOutputPort());
  filter->SetReferenceConnection(head->GetOutputPort());
  filter->FrontalOnlyOn();
  const auto rms = [&](const char* scheme) {
    face->SetScheme(scheme);
    filter->Update();
    RecordProperty(scheme, std::to_string(filter->GetRMSDistance(0)) + " maximum " +
                               std::to_string(filter->GetMaximumDistance(0)) + ", back " +
                               std::to_string(filter->GetRMSDistance(1)));
    return filter->GetRMSDistance(0);
  };
  EXPECT_LE(rms("spline"), 0.60);
  EXPECT_LE(rms("tangent"), 0.65);
  EXPECT_LE(rms("four-curve"), 0.75);
  filter->LargestComponentOnlyOn();
  const double withEyes = filter->GetMaximumDistance(1);
  EXPECT_LE(rms("spline"), 0.60);
  RecordProperty("skin", filter->GetMaximumDistance(1));
  EXPECT_LE(filter->GetMaximumDistance(1), withEyes);
}
