/// Sweeps over the smoothing parameter, one thread, beside what making and evaluating the same surfaces alone takes.
#include <benchmark/benchmark.h>

#include "FaceFiles.h"
#include "FaceSample.h"
#include "NumberRange.h"
#include "SmoothingSweep.h"

using namespace mien;

namespace {

SmoothingSweepOptions sweepOf(const std::string& scheme) {
  SmoothingSweepOptions options;
  options.schemes = {scheme};
  parseNumberRange("0.1:40:50log", options.smoothing);
  return options;
}

/// 50 values of a at 112 x 80 in all measures but distance.
void sweep(benchmark::State& state, const std::string& scheme) {
  const FaceCurves face = genericFace();
  for (auto _ : state) benchmark::DoNotOptimize(smoothingSweep(face, sweepOf(scheme)));
}

/// The same 50 surfaces with their derivatives to order 2, and no measure.
void surfacesOnly(benchmark::State& state, const std::string& scheme) {
  const FaceCurves face = genericFace();
  const SmoothingSweepOptions options = sweepOf(scheme);
  for (auto _ : state)
    for (const double a : options.smoothing) {
      FaceSurfaceOptions surface;
      surface.scheme = scheme;
      surface.smoothing.fill(a);
      benchmark::DoNotOptimize(FaceSample(face, surface, options.rows, options.columns).rowCount());
    }
}

}  // namespace

BENCHMARK_CAPTURE(sweep, fourCurve, std::string("four-curve"))->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(surfacesOnly, fourCurve, std::string("four-curve"))->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(sweep, curvature, std::string("curvature"))->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(surfacesOnly, curvature, std::string("curvature"))->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(sweep, spline, std::string("spline"))->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(surfacesOnly, spline, std::string("spline"))->Unit(benchmark::kMillisecond)->UseRealTime();
