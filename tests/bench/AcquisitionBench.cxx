/// From a scan of 100,000 triangles to boundary curves, beside reading the same scan through OpenMesh in the same run.
#include <benchmark/benchmark.h>

#include <fstream>

#include "DenseFace.h"
#include "ScanAcquisition.h"
#include "TemporaryFolder.h"
#include "vtkScanReader.h"

using namespace mien;

namespace {

const DenseFace& scan() {
  static const DenseFace face;
  return face;
}

void readOnly(benchmark::State& state) {
  const TemporaryFolder folder;
  const std::string name = folder.file("scan.obj");
  std::ofstream file(name);
  for (int i = 0; i < scan().mesh.vertices.rows(); ++i) file << "v " << scan().mesh.vertices.row(i) << "\n";
  for (int t = 0; t < scan().mesh.triangles.rows(); ++t)
    file << "f " << scan().mesh.triangles.row(t).array() + 1 << "\n";
  file.close();
  for (auto _ : state) {
    vtkNew<vtkScanReader> reader;
    reader->SetFileName(name.c_str());
    reader->Update();
    benchmark::DoNotOptimize(reader->GetOutput()->GetNumberOfPoints());
  }
}

void acquire(benchmark::State& state, bool landmarks) {
  LandmarkTable::Given given;
  given.fill(landmarks);
  referenceTemplate();
  for (auto _ : state) {
    AcquiredScan result;
    const std::string fault =
        acquireScan(cleaned(scan().mesh), given, scan().landmarks, referenceTemplate(), {}, result);
    if (!fault.empty()) state.SkipWithError(fault.c_str());
  }
}

}  // namespace

BENCHMARK(readOnly)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(acquire, withLandmarks, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(acquire, withoutLandmarks, false)->Unit(benchmark::kMillisecond)->Iterations(1);
