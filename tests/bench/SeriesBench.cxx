/// `mien animate` of 1,000 frames into .vts files: what of its processor time is computing, making the bytes, and the
/// plain write of the same bytes, all measured in the same run.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <ctime>
#include <vector>

#include "FacePipeline.h"
#include "Program.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLStructuredGridWriter.h"

using namespace mien;

namespace {

constexpr int frames = 1000, framesOfFile = 250;
const std::string demo = MIEN_DATA_DIR "/animation/demo.fap";

double ownTime() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double timeOfChildren() {
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double timeOf(const std::vector<std::string>& arguments, benchmark::State& state) {
  const double before = timeOfChildren();
  if (runMien(arguments).exitCode != 0) state.SkipWithError("mien failed");
  return timeOfChildren() - before;
}

template <class Work>
double timeOf(Work&& work) {
  const double before = ownTime();
  work();
  return ownTime() - before;
}

void computeGrids() {
  FacePipeline pipeline;
  FaceState face;
  face.fapFile = demo;
  for (int frame = 0; frame < frames; ++frame) {
    face.frame = frame % framesOfFile;
    pipeline.setState(face);
    pipeline.updateGrid();
  }
}

/// As the series makes them; of one frame again and again.
std::string bytesOf(vtkStructuredGrid* grid) {
  vtkNew<vtkXMLStructuredGridWriter> writer;
  writer->SetCompressorTypeToNone();
  writer->EncodeAppendedDataOff();
  writer->SetHeaderTypeToUInt32();
  writer->WriteToOutputStringOn();
  writer->SetInputData(grid);
  writer->Write();
  return writer->GetOutputString();
}

void plainWrites(const TemporaryFolder& folder, const std::string& bytes) {
  for (int frame = 0; frame < frames; ++frame) writeTextFile(folder.file(std::to_string(frame)), bytes);
}

void seriesOfSurfaces(benchmark::State& state) {
  for (auto _ : state) {
    const TemporaryFolder series, copies;
    const double start = timeOf({"animate", demo, "--frames", "0", "-o", series.file("one.pvd")}, state);
    const double program =
        timeOf({"animate", demo, "--frames", "0:249", "--loop", "4", "-o", series.file("film.pvd")}, state) - start;
    FacePipeline pipeline;
    pipeline.updateGrid();
    std::string bytes;
    state.counters["compute_s"] = timeOf(computeGrids);
    state.counters["bytes_s"] = timeOf([&] {
      for (int frame = 0; frame < frames; ++frame) bytes = bytesOf(pipeline.grid());
    });
    const double copy = timeOf([&] { plainWrites(copies, bytes); });
    state.counters["copy_s"] = copy;
    state.counters["megabytes"] = 1e-6 * static_cast<double>(bytes.size()) * frames;
    state.counters["copy_share"] = copy / program;
    state.SetIterationTime(program);
  }
}

}  // namespace

BENCHMARK(seriesOfSurfaces)->UseManualTime()->Iterations(1)->Unit(benchmark::kMillisecond);
