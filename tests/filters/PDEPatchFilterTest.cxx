#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPDEPatchFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace {

using Shape = std::function<Eigen::RowVector3d(double, double)>;

/// Closed curves cut from a shape at the given u.
mien::ClosedCurves cut(const Shape& shape, const std::vector<double>& u, int k = 24) {
  mien::ClosedCurves curves(static_cast<int>(u.size()), k);
  for (int c = 0; c < curves.count; ++c)
    for (int j = 0; j < k; ++j) curves.curve(c).row(j) = shape(u[c], 2 * M_PI * j / k);
  return curves;
}

struct Patch {
  vtkNew<vtkPolyData> curves;
  vtkNew<vtkPDEPatchFilter> filter;
  ErrorCounter errors{filter};
  explicit Patch(const mien::ClosedCurves& data) {
    mien::writeClosedCurves(data, curves);
    filter->SetInputData(curves);
    filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    filter->SetResolution(31, 48);
  }
  double largestError(const Shape& exact) {
    filter->Update();
    double error = 0.0;
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i) {
      const Eigen::RowVector3d p = Eigen::Map<const Eigen::RowVector3d>(filter->GetOutput()->GetPoint(i));
      error = std::max(error, (p - exact((i / 49) / 30.0, 2 * M_PI * (i % 49) / 48)).cwiseAbs().maxCoeff());
    }
    return error;
  }
};

const Shape vase = [](double u, double v) {
  return Eigen::RowVector3d((1 + u) * std::exp(-u) * std::cos(v), (1 + u) * std::exp(-u) * std::sin(v), 3 * u - u * u);
};

}  // namespace

TEST(PDEPatchFilter, ReturnsAnExactSolutionFromEvenlySpacedCurvesOfEveryOrder) {
  for (const int order : {4, 6, 8}) {
    std::vector<double> u;
    for (int i = 0; i < order; ++i) u.push_back(static_cast<double>(i) / (order - 1));
    Patch patch(cut(vase, u));
    EXPECT_LE(patch.largestError(vase), 1e-12) << order;
    EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 31 * 49);
    EXPECT_EQ(patch.errors.count(), 0);
  }
}

TEST(PDEPatchFilter, TakesDerivativeCurvesFromCellArrays) {
  mien::ClosedCurves curves = cut(vase, {0.0, 0.0, 1.0, 1.0});
  for (const int c : {1, 3})
    for (int j = 0; j < 24; ++j) {
      const double u = c / 2, v = 2 * M_PI * j / 24, slope = -u * std::exp(-u);
      curves.curve(c).row(j) << slope * std::cos(v), slope * std::sin(v), 3 - 2 * u;
    }
  Patch patch(curves);
  vtkNew<vtkDoubleArray> u;
  u->SetName("U");
  vtkNew<vtkIntArray> derivative;
  derivative->SetName("Derivative");
  for (int c = 0; c < 4; ++c) {
    u->InsertNextValue(c / 2);
    derivative->InsertNextValue(c % 2);
  }
  patch.curves->GetCellData()->AddArray(u);
  patch.curves->GetCellData()->AddArray(derivative);
  EXPECT_LE(patch.largestError(vase), 1e-12);
}

TEST(PDEPatchFilter, RefusesWhatMakesNoPatch) {
  const auto refused = [](Patch& patch, const char* word) {
    patch.filter->Update();
    EXPECT_NE(patch.errors.first().find(word), std::string::npos) << patch.errors.first();
    EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  Patch three(cut(vase, {0, 0.5, 1}));
  refused(three, "3 curves");
  Patch twice(cut(vase, {0, 0, 0.5, 1}));
  for (const double u : {0.0, 0.0, 0.5, 1.0}) twice.filter->AddCondition(u, 0);
  refused(twice, "determine");
  Patch outside(cut(vase, {0, 0.3, 0.5, 1}));
  for (const double u : {0.0, 0.3, 0.5, 1.5}) outside.filter->AddCondition(u, 0);
  refused(outside, "condition of curve 4");
  Patch modes(cut(vase, {0, 0.3, 0.5, 1}));
  modes.filter->SetNumberOfModes(13);
  refused(modes, "0 .. 12");
}

TEST(PDEPatchFilter, PiecesWithGhostLevelsEqualTheWhole) {
  const mien::ClosedCurves curves = cut(vase, {0, 0.3, 0.6, 1});
  Patch whole(curves);
  whole.filter->Update();
  for (const int pieces : {2, 3, 7})
    for (const int ghostLevels : {0, 1, 2}) {
      Patch part(curves);
      std::vector<int> owners(30 * 48, 0);
      for (int piece = 0; piece < pieces; ++piece) {
        part.filter->UpdatePiece(piece, pieces, ghostLevels);
        vtkStructuredGrid* grid = part.filter->GetOutput();
        int extent[6];
        grid->GetExtent(extent);
        EXPECT_LT(grid->GetNumberOfPoints(), 31 * 49);
        for (int j = extent[2]; j <= extent[3]; ++j)
          for (int i = extent[0]; i <= extent[1]; ++i) {
            int ijk[3] = {i, j, 0};
            const vtkIdType id = vtkStructuredData::ComputePointIdForExtent(extent, ijk);
            for (int c = 0; c < 3; ++c) {
              // double precision: sums over fewer columns are grouped otherwise and differ in their last digit
              ASSERT_NEAR(grid->GetPoint(id)[c], whole.filter->GetOutput()->GetPoint(j * 49 + i)[c], 1e-14)
                  << i << " " << j;
              ASSERT_NEAR(grid->GetPointData()->GetNormals()->GetComponent(id, c),
                          whole.filter->GetOutput()->GetPointData()->GetNormals()->GetComponent(j * 49 + i, c), 1e-14);
            }
            if (i == extent[1] || j == extent[3]) continue;
            vtkUnsignedCharArray* ghosts = grid->GetCellGhostArray();
            const vtkIdType cell = vtkStructuredData::ComputeCellIdForExtent(extent, ijk);
            owners[j * 48 + i] += !(ghosts && (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL));
          }
      }
      EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), 30 * 48)
          << pieces << " pieces, " << ghostLevels << " ghost levels";
      EXPECT_EQ(part.errors.count(), 0);
    }
}

TEST(PDEPatchFilter, RunsAgainOnlyWhenSomethingChanged) {
  Patch patch(cut(vase, {0, 0.3, 0.6, 1}));
  int runs = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&runs);
  counter->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  patch.filter->AddObserver(vtkCommand::EndEvent, counter);
  const auto runsAfterUpdate = [&] {
    patch.filter->Update();
    return runs;
  };
  EXPECT_EQ(runsAfterUpdate(), 1);
  patch.filter->SetSmoothing(patch.filter->GetSmoothing());
  patch.filter->SetNumberOfModes(patch.filter->GetNumberOfModes());
  patch.filter->SetRemainder(patch.filter->GetRemainder());
  patch.filter->SetResolution(31, 48);
  EXPECT_EQ(runsAfterUpdate(), 1);
  patch.filter->SetSmoothing(2.0);
  EXPECT_EQ(runsAfterUpdate(), 2);
  for (const double u : {0.0, 0.3, 0.6, 1.0}) patch.filter->AddCondition(u, 0);
  EXPECT_EQ(runsAfterUpdate(), 3);
  patch.filter->ClearConditions();
  EXPECT_EQ(runsAfterUpdate(), 4);
  patch.curves->GetPoints()->SetPoint(30, 0.5, 0.25, 1.0);
  patch.curves->GetPoints()->Modified();
  patch.curves->Modified();
  EXPECT_EQ(runsAfterUpdate(), 5);
}

TEST(PDEPatchFilter, AnAbortedUpdateLeavesNoHalfOutput) {
  Patch patch(cut(vase, {0, 0.3, 0.6, 1}));
  patch.filter->SetResolution(2000, 2000);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const auto observer = patch.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  patch.filter->Update();
  EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 0);
  patch.filter->RemoveObserver(observer);
  patch.filter->SetAbortExecute(0);
  patch.filter->Modified();
  patch.filter->Update();
  EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 2000 * 2001);
}

TEST(PDEPatchFilter, EmptyInputIsRefused) {
  Patch patch(cut(vase, {0, 0.3, 0.6, 1}));
  patch.filter->Update();
  patch.curves->Initialize();
  patch.curves->Modified();
  patch.filter->Update();
  EXPECT_NE(patch.errors.first().find("there are no lines"), std::string::npos) << patch.errors.first();
  EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(PDEPatchFilter, RefusesCellArraysThatAreNoConditions) {
  const auto refused = [](const std::vector<double>& orders, const char* word) {
    Patch patch(cut(vase, {0.0, 0.3, 0.6, 1.0}));
    vtkNew<vtkDoubleArray> u, derivative;
    u->SetName("U");
    derivative->SetName("Derivative");
    for (const double value : {0.0, 0.3, 0.6, 1.0}) u->InsertNextValue(value);
    for (const double order : orders) derivative->InsertNextValue(order);
    patch.curves->GetCellData()->AddArray(u);
    patch.curves->GetCellData()->AddArray(derivative);
    patch.filter->Update();
    EXPECT_NE(patch.errors.first().find(word), std::string::npos) << patch.errors.first();
    EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  refused({0.0, 0.0}, "Derivative has 2 values");
  refused({0.0, std::nan(""), 0.0, 0.0}, "Derivative, curve 2");
  refused({0.0, 0.0, 1e300, 0.0}, "Derivative, curve 3");
  refused({0.0, 0.0, 0.0, -1.0}, "Derivative, curve 4");
  refused({0.5, 0.0, 0.0, 0.0}, "Derivative, curve 1");
  refused({0.0, 0.0, 0.0, 4.0}, "derivative = 0 .. 3");
}

TEST(PDEPatchFilter, RefusesAResolutionOutOfRange) {
  for (const auto& [rows, columns] : {std::pair{1, 40}, {40, 2}, {2, 2000000000}, {2000000000, 3}, {100000, 100000}}) {
    Patch patch(cut(vase, {0.0, 0.3, 0.6, 1.0}));
    patch.filter->SetResolution(rows, columns);
    patch.filter->Update();
    EXPECT_NE(patch.errors.first().find("resolution of"), std::string::npos) << rows << "x" << columns;
    EXPECT_EQ(patch.filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}
