/// All eight seams of a face and its spectrum, beside memcpy of what they compute in the same run.
#include <benchmark/benchmark.h>

#include <cstring>

#include "BoundaryCurveData.h"
#include "FaceFiles.h"
#include "FaceSeams.h"
#include "ModeSpectrum.h"
#include "vtkNew.h"
#include "vtkPatchContinuityFilter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace mien;

namespace {

FaceSurfaceOptions withScheme(const std::string& scheme) {
  FaceSurfaceOptions options;
  options.scheme = scheme;
  return options;
}

/// New curves, kept operators.
void seams(benchmark::State& state, const std::string& scheme) {
  const FaceCurves face = genericFace();
  FaceSeams measured(withScheme(scheme), face.curves.pointsPerCurve, static_cast<int>(state.range(0)));
  for (auto _ : state) {
    measured.setCurves(face.curves);
    benchmark::DoNotOptimize(measured.whole(0).max().g1);
  }
}

/// A change of scheme, a or N: new operators as well.
void seamsWithOperators(benchmark::State& state, const std::string& scheme) {
  const FaceCurves face = genericFace();
  for (auto _ : state) {
    FaceSeams measured(withScheme(scheme), face.curves.pointsPerCurve, static_cast<int>(state.range(0)));
    measured.setCurves(face.curves);
    benchmark::DoNotOptimize(measured.whole(0).max().g1);
  }
}

/// The jets of both sides of all seams, copied.
void memcpyOfJets(benchmark::State& state) {
  const size_t bytes = sizeof(SurfaceJet) * 2 * FaceSeams::seamCount * state.range(0);
  std::vector<char> from(bytes, 1), to(bytes, 2);
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), bytes);
    benchmark::ClobberMemory();
  }
}

/// Curves to polylines and table through the VTK pipeline.
void seamPipeline(benchmark::State& state) {
  vtkNew<vtkPolyData> curves;
  writeFaceCurves(genericFace(), curves);
  vtkNew<vtkPatchContinuityFilter> filter;
  filter->SetInputData(curves);
  filter->SetNumberOfSamples(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    curves->Modified();
    filter->Update();
  }
}

void spectrum(benchmark::State& state) {
  const FaceCurves face = genericFace();
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(state.range(1) + 1, 0.0, 2.0 * M_PI);
  ModeSpectrum measured({}, RowLayout(static_cast<int>(state.range(0)), false), face.curves.pointsPerCurve, v);
  for (auto _ : state) {
    measured.setCurves(face.curves);
    benchmark::DoNotOptimize(measured.measures());
  }
}

}  // namespace

BENCHMARK_CAPTURE(seams, spline, std::string("spline"))->Arg(400)->Arg(20000)->UseRealTime();
BENCHMARK_CAPTURE(seams, fourCurve, std::string("four-curve"))->Arg(400)->UseRealTime();
BENCHMARK_CAPTURE(seamsWithOperators, spline, std::string("spline"))->Arg(400)->UseRealTime();
BENCHMARK(memcpyOfJets)->Arg(400)->UseRealTime();
BENCHMARK(seamPipeline)->Arg(400)->UseRealTime();
BENCHMARK(spectrum)->Args({56, 40})->Args({224, 160})->UseRealTime();
