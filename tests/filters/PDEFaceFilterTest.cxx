#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "RandomCurves.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

using mien::FaceCurves;

namespace {

struct FilteredFace {
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPDEFaceFilter> filter;
  ErrorCounter errors{filter};

  explicit FilteredFace(const FaceCurves& face = randomFace()) {
    mien::writeFaceCurves(face, curves);
    filter->SetInputData(curves);
  }
  vtkStructuredGrid* grid() { return filter->GetOutput(); }
};

/// Tuple of a point array at column i and row j in whole-extent indices.
std::array<double, 3> at(vtkStructuredGrid* grid, vtkDataArray* array, int i, int j) {
  int ijk[3] = {i, j, 0};
  std::array<double, 3> value{};
  array->GetTuple(vtkStructuredData::ComputePointIdForExtent(grid->GetExtent(), ijk), value.data());
  return value;
}

}  // namespace

TEST(PDEFaceFilter, GivesTheDocumentedGrid) {
  FilteredFace face;
  face.filter->Update();
  EXPECT_EQ(face.errors.count(), 0);
  int dimensions[3];
  face.grid()->GetDimensions(dimensions);
  EXPECT_EQ(dimensions[0], 41);
  EXPECT_EQ(dimensions[1], 56);
  vtkPointData* points = face.grid()->GetPointData();
  ASSERT_NE(points->GetArray("Normals"), nullptr);
  ASSERT_NE(points->GetArray("TextureCoordinates"), nullptr);
  EXPECT_EQ(points->GetArray("Su"), nullptr);
  ASSERT_NE(face.grid()->GetCellData()->GetArray("PatchId"), nullptr);
  double range[2];
  face.grid()->GetCellData()->GetArray("PatchId")->GetRange(range);
  EXPECT_EQ(range[0], 0);
  EXPECT_EQ(range[1], 8);
  vtkDataArray* coordinates = face.grid()->GetPoints()->GetData();
  for (int j = 0; j < 56; ++j) EXPECT_EQ(at(face.grid(), coordinates, 0, j), at(face.grid(), coordinates, 40, j));
  EXPECT_EQ(at(face.grid(), points->GetArray("TextureCoordinates"), 40, 55)[0], 1.0);
  EXPECT_EQ(at(face.grid(), points->GetArray("TextureCoordinates"), 40, 55)[1], 0.0);
}

// Curves of a torus about y, its tube of radius 150 seen from the outer side.
TEST(PDEFaceFilter, CurvaturesOfATorusComeOut) {
  const double axisDistance = 40.0, tube = 150.0;
  const auto angle = [](double chain) { return 0.8 + 1.5 * chain / 27.0; };
  FaceCurves torus = randomFace();
  for (int c = 0; c < mien::FaceLayout::curveCount; ++c)
    for (int j = 0; j < 40; ++j) {
      const double v = 2.0 * M_PI * j / 40, a = angle(c > mien::FaceLayout::upperLip ? c - 1 : c);
      const double radius = axisDistance + tube * std::sin(a);
      torus.curves.curve(c).row(j) << -radius * std::sin(v), tube * std::cos(a), -radius * std::cos(v);
    }
  FilteredFace face(torus);
  face.filter->SetGenerateCurvatures(true);
  face.filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  face.filter->SetSmoothing(0.01);
  face.filter->Update();
  EXPECT_EQ(face.errors.count(), 0);
  const auto value = [&](const char* name, int j) {
    return at(face.grid(), face.grid()->GetPointData()->GetArray(name), 11, j)[0];
  };
  // away from the natural ends the spline follows the arc: an interval turns by 3.2 degrees
  for (int j = 16; j < 40; ++j) {
    double point[3];
    int ijk[3] = {11, j, 0};
    face.grid()->GetPoint(vtkStructuredData::ComputePointIdForExtent(face.grid()->GetExtent(), ijk), point);
    const double radius = std::hypot(point[0], point[2]);
    const double aroundAxis = (radius - axisDistance) / (tube * radius), aroundTube = 1.0 / tube;
    EXPECT_NEAR(value("MaximumCurvature", j), std::max(aroundTube, aroundAxis), 2e-3 / tube) << j;
    EXPECT_NEAR(value("MinimumCurvature", j), std::min(aroundTube, aroundAxis), 2e-3 / tube) << j;
    EXPECT_NEAR(value("MeanCurvature", j), 0.5 * (aroundTube + aroundAxis), 2e-3 / tube) << j;
    EXPECT_NEAR(value("GaussianCurvature", j), aroundTube * aroundAxis, 4e-3 / (tube * tube)) << j;
  }
}

TEST(PDEFaceFilter, CurvaturesAreThereOnlyWhenAskedFor) {
  FilteredFace face;
  face.filter->Update();
  EXPECT_EQ(face.grid()->GetPointData()->GetArray("MeanCurvature"), nullptr);
  face.filter->SetGenerateCurvatures(true);
  face.filter->Update();
  ASSERT_NE(face.grid()->GetPointData()->GetArray("MeanCurvature"), nullptr);
  EXPECT_EQ(face.grid()->GetPointData()->GetArray("MeanCurvature")->GetNumberOfTuples(), 56 * 41);
  EXPECT_EQ(face.grid()->GetPointData()->GetArray("GaussianCurvature")->GetDataType(), VTK_FLOAT);
  face.filter->SetGenerateCurvatures(false);
  face.filter->Update();
  EXPECT_EQ(face.grid()->GetPointData()->GetArray("MeanCurvature"), nullptr);
}

TEST(PDEFaceFilter, PiecesWithGhostLevelsEqualTheWhole) {
  FilteredFace whole;
  whole.filter->SetGenerateCurvatures(true);
  whole.filter->SetGenerateDerivatives(true);
  whole.filter->Update();
  for (const int pieces : {2, 3, 7})
    for (const int ghostLevels : {0, 1, 2}) {
      FilteredFace part;
      part.filter->SetGenerateDerivatives(true);
      part.filter->SetGenerateCurvatures(true);
      std::vector<int> owned(56 * 41, 0);
      for (int piece = 0; piece < pieces; ++piece) {
        part.filter->UpdatePiece(piece, pieces, ghostLevels);
        int extent[6];
        part.grid()->GetExtent(extent);
        EXPECT_LT((extent[1] - extent[0] + 1) * (extent[3] - extent[2] + 1), 56 * 41);
        for (const char* name : {"", "Normals", "TextureCoordinates", "Su", "Sv", "MeanCurvature", "MinimumCurvature"})
          for (int j = extent[2]; j <= extent[3]; ++j)
            for (int i = extent[0]; i <= extent[1]; ++i) {
              const auto array = [&](vtkStructuredGrid* g) {
                return *name ? g->GetPointData()->GetArray(name) : g->GetPoints()->GetData();
              };
              ASSERT_EQ(at(part.grid(), array(part.grid()), i, j), at(whole.grid(), array(whole.grid()), i, j))
                  << name << " " << i << " " << j;
              owned[j * 41 + i]++;
            }
      }
      EXPECT_EQ(std::count(owned.begin(), owned.end(), 0), 0);
    }
}

TEST(PDEFaceFilter, CellsThatAreNoDuplicatesMakeUpTheWholeOnce) {
  FaceCurves curves = randomFace();
  curves.features = {{"2.4", 21, M_PI + 0.6}, {"2.5", 21, M_PI - 0.6}};
  FilteredFace whole(curves);
  whole.filter->Update();
  vtkDataArray* patches = whole.grid()->GetCellData()->GetArray("PatchId");
  for (const int pieces : {2, 3, 7})
    for (const int ghostLevels : {1, 2}) {
      FilteredFace part(curves);
      std::vector<int> owners(55 * 40, 0);
      int duplicates = 0;
      for (int piece = 0; piece < pieces; ++piece) {
        part.filter->UpdatePiece(piece, pieces, ghostLevels);
        vtkUnsignedCharArray* ghosts = part.grid()->GetCellGhostArray();
        ASSERT_NE(ghosts, nullptr);
        int extent[6];
        part.grid()->GetExtent(extent);
        for (int j = extent[2]; j < extent[3]; ++j)
          for (int i = extent[0]; i < extent[1]; ++i) {
            int ijk[3] = {i, j, 0};
            const vtkIdType cell = vtkStructuredData::ComputeCellIdForExtent(extent, ijk);
            const bool duplicate = ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL;
            duplicates += duplicate;
            owners[j * 40 + i] += !duplicate;
            EXPECT_EQ(part.grid()->GetCellData()->GetArray("PatchId")->GetTuple1(cell), patches->GetTuple1(j * 40 + i))
                << i << " " << j;
          }
      }
      EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), 55 * 40)
          << pieces << " pieces, " << ghostLevels << " ghost levels";
      EXPECT_GT(duplicates, 0);
    }
}

TEST(PDEFaceFilter, PiecesHideTheSameCellsAsTheWhole) {
  FaceCurves curves = randomFace();
  curves.features = {{"2.4", 21, M_PI + 0.6}, {"2.5", 21, M_PI - 0.6}};
  FilteredFace whole(curves);
  whole.filter->Update();
  const auto hidden = [](vtkStructuredGrid* grid, int i, int j) {
    int ijk[3] = {i, j, 0};
    return !grid->IsCellVisible(vtkStructuredData::ComputeCellIdForExtent(grid->GetExtent(), ijk));
  };
  int count = 0;
  for (int i = 0; i < 40; ++i) count += hidden(whole.grid(), i, 42);
  EXPECT_EQ(count, 8);  // 1.2 radians of 2 pi / 40 each
  for (const int ghostLevels : {0, 1}) {
    FilteredFace part(curves);
    for (int piece = 0; piece < 3; ++piece) {
      part.filter->UpdatePiece(piece, 3, ghostLevels);
      int extent[6];
      part.grid()->GetExtent(extent);
      for (int j = extent[2]; j < extent[3]; ++j)
        for (int i = extent[0]; i < extent[1]; ++i)
          EXPECT_EQ(hidden(part.grid(), i, j), hidden(whole.grid(), i, j))
              << i << " " << j << " ghosts " << ghostLevels;
    }
  }
}

TEST(PDEFaceFilter, SlitIsHiddenBetweenTheMouthCornersOnly) {
  FaceCurves curves = randomFace();
  curves.features = {{"2.4", 21, M_PI + 0.6}, {"2.5", 21, M_PI - 0.6}};
  FilteredFace face(curves);
  vtkNew<vtkGeometryFilter> geometry;
  geometry->SetInputConnection(face.filter->GetOutputPort());
  geometry->Update();
  EXPECT_EQ(geometry->GetOutput()->GetNumberOfCells(), 55 * 40 - 8);
}

TEST(PDEFaceFilter, RunsAgainOnlyWhenSomethingChanged) {
  FilteredFace face;
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  face.filter->AddObserver(vtkCommand::EndEvent, counter);
  face.filter->Update();
  face.filter->Update();
  EXPECT_EQ(runs, 1);
  face.filter->SetSmoothing(1.0);
  face.filter->SetScheme("spline");
  face.filter->SetResolution(56, 40);
  face.filter->Update();
  EXPECT_EQ(runs, 1);
  face.filter->SetSmoothing(3, 2.0);
  face.filter->Update();
  EXPECT_EQ(runs, 2);
  face.curves->GetPoints()->SetPoint(400, 1, 2, 3);
  face.curves->GetPoints()->Modified();
  face.curves->Modified();
  face.filter->Update();
  EXPECT_EQ(runs, 3);
}

TEST(PDEFaceFilter, KeptOperatorsGiveWhatNewOnesGive) {
  FilteredFace kept;
  kept.filter->Update();
  const FaceCurves other = randomFace(40, 7);
  mien::writeFaceCurves(other, kept.curves);
  kept.filter->SetScheme("derivative");
  kept.filter->Update();
  kept.filter->SetScheme("spline");
  kept.filter->Update();
  FilteredFace fresh(other);
  fresh.filter->Update();
  for (vtkIdType i = 0; i < fresh.grid()->GetNumberOfPoints(); ++i)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(kept.grid()->GetPoint(i)[c], fresh.grid()->GetPoint(i)[c]);
}

TEST(PDEFaceFilter, PrecisionIsThatAskedFor) {
  FilteredFace single, precise;
  precise.filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  single.filter->Update();
  precise.filter->Update();
  EXPECT_EQ(single.grid()->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(precise.grid()->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < single.grid()->GetNumberOfPoints(); ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(single.grid()->GetPoint(i)[c], precise.grid()->GetPoint(i)[c], 1e-4);
}

TEST(PDEFaceFilter, SmoothingOfOnePatchChangesThatPatchOnly) {
  FilteredFace one, other;
  one.filter->SetScheme("four-curve");
  other.filter->SetScheme("four-curve");
  other.filter->SetSmoothing(4, 3.0);
  one.filter->Update();
  other.filter->Update();
  for (vtkIdType i = 0; i < one.grid()->GetNumberOfPoints(); ++i) {
    const int row = static_cast<int>(i / 41);
    if (row > 24 && row < 30 && row % 2) {
      EXPECT_NE(one.grid()->GetPoint(i)[0], other.grid()->GetPoint(i)[0]);
    }
    if (row <= 24 || row >= 30) {
      EXPECT_EQ(one.grid()->GetPoint(i)[0], other.grid()->GetPoint(i)[0]);
    }
  }
}

/// A face that `change` spoils is refused with a message that has `word`.
template <class Change>
void refused(Change change, const char* word) {
  FilteredFace face;
  change(face);
  face.filter->Update();
  EXPECT_GE(face.errors.count(), 1) << word;
  EXPECT_NE(face.errors.first().find(word), std::string::npos) << face.errors.first();
  EXPECT_EQ(face.grid()->GetNumberOfPoints(), 0) << word;
}

TEST(PDEFaceFilter, RefusesWhatItCannotSolveAndLeavesNoOutput) {
  refused([](FilteredFace& f) { f.filter->SetScheme("none"); }, "four-curve");
  refused([](FilteredFace& f) { f.filter->SetSmoothing(-1.0); }, "0 < a <= 1000");
  refused([](FilteredFace& f) { f.filter->SetNumberOfModes(21); }, "0 .. 20");
  refused(
      [](FilteredFace& f) {
        f.filter->SetScheme("four-curve");
        f.filter->SetSmoothing(50.0);
      },
      "250");
  refused([](FilteredFace& f) { f.filter->SetResolution(10, 40); }, "11x3");
  refused([](FilteredFace& f) { f.filter->SetResolution(56, 2000000000); }, "too fine");
  refused([](FilteredFace& f) { f.filter->SetResolution(20000, 20000); }, "in pieces");
  refused([](FilteredFace& f) { f.filter->SetDerivativeStrength(1e9); }, "-1000 .. 1000");
  refused([](FilteredFace& f) { f.filter->SetDerivativeStrength(NAN); }, "-1000 .. 1000");
}

TEST(PDEFaceFilter, DataAfterRefusedInformationAreRefusedToo) {
  FilteredFace face;
  face.filter->SetResolution(5, 40);
  face.filter->UpdateInformation();
  face.filter->Update();
  EXPECT_NE(face.errors.first().find("11x3"), std::string::npos) << face.errors.first();
  EXPECT_EQ(face.grid()->GetNumberOfPoints(), 0);
}

TEST(PDEFaceFilter, RefusesBrokenCurvesAndLeavesNoOutput) {
  refused(
      [](FilteredFace& f) {
        f.curves->GetPoints()->SetPoint(0, NAN, 0, 0);
        f.curves->Modified();
      },
      "not a finite");
  refused(
      [](FilteredFace& f) {
        vtkStringArray::SafeDownCast(f.curves->GetFieldData()->GetAbstractArray("Units"))->SetValue(0, "cm");
      },
      "'cm'");
  refused(
      [](FilteredFace& f) {
        f.curves->GetPoints()->SetPoint(3, NAN, 0, 0);
        f.curves->Modified();
      },
      "not a finite");
  refused(
      [](FilteredFace& f) {
        f.curves->GetPoints()->SetPoint(3, 0, -500, 0);
        f.curves->Modified();
      },
      "C1");
  refused([](FilteredFace& f) { f.curves->Initialize(); }, "no lines");
}

TEST(PDEFaceFilter, AnAbortedUpdateLeavesNoHalfOutput) {
  FilteredFace face;
  face.filter->SetResolution(2000, 2000);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const auto observer = face.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  face.filter->Update();
  EXPECT_EQ(face.grid()->GetNumberOfPoints(), 0);
  face.filter->RemoveObserver(observer);
  face.filter->SetAbortExecute(0);
  face.filter->Modified();
  face.filter->Update();
  EXPECT_EQ(face.grid()->GetNumberOfPoints(), 2000 * 2001);
}

TEST(PDEFaceFilter, CopiesParametersOfAnotherFilter) {
  FilteredFace one, other;
  one.filter->SetScheme("tangent");
  one.filter->SetSmoothing(3, 2.5);
  one.filter->SetNumberOfModes(7);
  one.filter->SetRemainder(false);
  one.filter->SetDerivativeStrength(0.25);
  other.filter->CopyParameters(one.filter);
  EXPECT_EQ(other.filter->GetScheme(), "tangent");
  EXPECT_EQ(other.filter->GetSmoothing(3), 2.5);
  EXPECT_EQ(other.filter->GetSmoothing(4), 1.0);
  EXPECT_EQ(other.filter->GetNumberOfModes(), 7);
  EXPECT_FALSE(other.filter->GetRemainder());
  EXPECT_EQ(other.filter->GetDerivativeStrength(), 0.25);
  const vtkMTimeType before = other.filter->GetMTime();
  other.filter->CopyParameters(one.filter);
  EXPECT_EQ(other.filter->GetMTime(), before);
}
