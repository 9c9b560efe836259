/// From curves to surfaces, beside memcpy of the same output in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "BoundaryCurveData.h"
#include "FaceSurface.h"
#include "PDESurface.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

using namespace mien;

namespace {

FaceCurves genericFace() {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  FaceCurves face;
  readFaceCurves(reader->GetOutput(), face);
  return face;
}

/// Curves to points and normals in the core, one thread.
void coreSurface(benchmark::State& state, const std::string& scheme) {
  const int rows = static_cast<int>(state.range(0)), columns = static_cast<int>(state.range(1));
  const FaceCurves face = genericFace();
  FaceSurfaceOptions options;
  options.scheme = scheme;
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(columns + 1, 0.0, 2.0 * M_PI);
  PDESurface<float> surface(facePieces(options, RowLayout(rows, false)), HarmonicSplit(40, 5, true),
                            FaceLayout::curveCount, v);
  RowMajor<float> points(rows, v.size() * 3), normals(rows, v.size() * 3);
  using Grid = PDESurface<float>::Grid;
  for (auto _ : state) {
    surface.setCurves(face.curves);
    surface.evaluateWithNormals(0, Grid(points.data(), rows, points.cols()), Grid(normals.data(), rows, points.cols()));
    benchmark::ClobberMemory();
  }
}

/// The same number of bytes, points and normals, copied.
void memcpyOfOutput(benchmark::State& state) {
  const size_t bytes = 2 * 3 * sizeof(float) * state.range(0) * (state.range(1) + 1);
  std::vector<char> from(bytes, 1), to(bytes, 2);
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), bytes);
    benchmark::ClobberMemory();
  }
}

/// Curves to grid through the VTK pipeline.
void pipelineSurface(benchmark::State& state) {
  const FaceCurves face = genericFace();
  vtkSMPTools::Initialize(static_cast<int>(state.range(2)));
  vtkNew<vtkPolyData> curves;
  writeFaceCurves(face, curves);
  vtkNew<vtkPDEFaceFilter> filter;
  filter->SetInputData(curves);
  filter->SetResolution(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    curves->GetPoints()->Modified();
    curves->Modified();
    filter->Update();
  }
}

}  // namespace

BENCHMARK_CAPTURE(coreSurface, fourCurve, std::string("four-curve"))->Args({56, 40})->Args({1000, 1000})->UseRealTime();
BENCHMARK(memcpyOfOutput)->Args({56, 40})->Args({1000, 1000})->UseRealTime();
BENCHMARK(pipelineSurface)
    ->ArgNames({"rows", "columns", "threads"})
    ->Args({56, 40, 1})
    ->Args({1000, 1000, 1})
    ->Args({1000, 1000, 2})
    ->UseRealTime();
