/// A warp of 4096 x 4096 pixels, beside memcpy of the image and a transform of it by vtkImageReslice in the same run.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

#include "TestImages.h"
#include "WarpMeshData.h"
#include "vtkImageMeshWarpFilter.h"
#include "vtkImageReslice.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkTransform.h"

using namespace mien;

namespace {

constexpr int side = 4096;

vtkImageData* picture() {
  static const auto image = wavyImage(side, side, VTK_UNSIGNED_CHAR, 3, 255.0);
  return image;
}

void meshWarp(benchmark::State& state) {
  vtkSMPTools::Initialize(static_cast<int>(state.range(0)));
  vtkNew<vtkStructuredGrid> source, target;
  writeWarpMesh(bentMesh(7, 7, side, side, 0.3, 0.0), source);
  writeWarpMesh(bentMesh(7, 7, side, side, 0.3, 2.0), target);
  vtkNew<vtkImageMeshWarpFilter> filter;
  filter->SetInputData(picture());
  filter->SetSourceMeshData(source);
  filter->SetTargetMeshData(target);
  for (auto _ : state) {
    filter->Modified();
    filter->Update();
  }
}

/// One turn with linear interpolation.
void reslice(benchmark::State& state) {
  vtkNew<vtkTransform> turn;
  turn->RotateZ(5.0);
  vtkNew<vtkImageReslice> filter;
  filter->SetInputData(picture());
  filter->SetResliceTransform(turn);
  filter->SetInterpolationModeToLinear();
  filter->SetNumberOfThreads(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    filter->Modified();
    filter->Update();
  }
}

void memcpyOfImage(benchmark::State& state) {
  const std::size_t bytes = std::size_t(3) * side * side;
  std::vector<char> to(bytes);
  for (auto _ : state) {
    std::memcpy(to.data(), picture()->GetScalarPointer(), bytes);
    benchmark::ClobberMemory();
  }
}

}  // namespace

BENCHMARK(meshWarp)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(reslice)->ArgName("threads")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(memcpyOfImage)->Unit(benchmark::kMillisecond)->UseRealTime();
