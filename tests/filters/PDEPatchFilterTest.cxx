#include "vtkPDEPatchFilter.h"

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

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
  refused(outside, "condition 3");
  Patch modes(cut(vase, {0, 0.3, 0.5, 1}));
  modes.filter->SetNumberOfModes(13);
  refused(modes, "0 .. 12");
}
