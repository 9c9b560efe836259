/// From curves to surfaces, beside memcpy of the same output in the same run.
#include <benchmark/benchmark.h>

#include <cstring>

#include "BoundaryCurveData.h"
#include "FaceFiles.h"
#include "FrameSurface.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

using namespace mien;

namespace {

/// Curves to points and normals in the core, one thread.
void coreSurface(benchmark::State& state, const std::string& scheme) {
  const FaceCurves face = genericFace();
  FrameSurface surface(scheme, static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    surface.update(face.curves);
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
  filter->SetScheme("four-curve");
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
