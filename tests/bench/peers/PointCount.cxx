/// The same surface at ever more points, buffers warm: the time of a point has to stay what it is.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include "FaceFiles.h"
#include "FrameSurface.h"

namespace {

double freeBytes() {
  return static_cast<double>(sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void pointCount(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  if (freeBytes() < 32.0 * size * size) return state.SkipWithError("too little memory is free");
  const auto face = genericFace();
  FrameSurface surface("four-curve", size, size);
  surface.update(face.curves);
  for (auto _ : state) {
    surface.update(face.curves);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations()) * size * (size + 1));
}

}  // namespace

BENCHMARK(pointCount)
    ->Name("peer/pointCount")
    ->MinTime(2.0)
    ->Unit(benchmark::kMillisecond)
    ->Arg(125)
    ->Arg(250)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(4000)
    ->Arg(8000);
