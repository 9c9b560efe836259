/// From FAP frames to curves and surfaces, beside memcpy of the same output in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "FAPParser.h"
#include "FAPTable.h"
#include "FAPWriter.h"
#include "FaceAnimator.h"
#include "FrameSurface.h"
#include "MovingFace.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

using namespace mien;

namespace {

void frameToCurves(benchmark::State& state) {
  FaceAnimator animator = genericAnimator();
  int index = 0;
  for (auto _ : state) benchmark::DoNotOptimize(animator.animate(movingFrame(index++)).points.data());
}

void frameToSurface(benchmark::State& state, const std::string& scheme) {
  FaceAnimator animator = genericAnimator();
  FrameSurface surface(scheme);
  int index = 0;
  for (auto _ : state) {
    surface.update(animator.animate(movingFrame(index++)));
    benchmark::ClobberMemory();
  }
}

/// A file of 1,000 frames to curves and to a surface of 56 x 40 with normals: under 0.1 s in one thread is asked for.
void thousandFrames(benchmark::State& state, const std::string& scheme) {
  FAPSequence sequence;
  for (int index = 0; index < 1000; ++index) {
    FAPFrame frame = movingFrame(index);
    for (const int fap : {3, 4, 5, 8, 9, 10, 11, 21, 22, 37, 38, 55, 56, 57, 58})
      frame.setValue(fap, 90.0 * std::sin(0.07 * index + fap));
    frame.number = index;
    sequence.frames.push_back(frame);
    sequence.masks.emplace_back().set();
  }
  std::string text;
  if (!writeFAP(sequence, text).empty()) return state.SkipWithError("the file cannot be written");
  FaceAnimator animator = genericAnimator();
  FrameSurface surface(scheme);
  for (auto _ : state) {
    FAPSequence played;
    if (parseFAP(text, played)) return state.SkipWithError("the file cannot be read");
    for (const FAPFrame& frame : played.frames) {
      surface.update(animator.animate(frame));
      benchmark::ClobberMemory();
    }
  }
}

void frameThroughPipeline(benchmark::State& state, const std::string& scheme) {
  vtkSMPTools::Initialize(1);
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkFAPAnimationFilter> animation;
  vtkNew<vtkPDEFaceFilter> face;
  animation->SetInputConnection(reader->GetOutputPort());
  face->SetInputConnection(animation->GetOutputPort());
  face->SetScheme(scheme);
  int index = 0;
  for (auto _ : state) {
    const FAPFrame frame = movingFrame(index++);
    for (const int fap : paperSubset()) animation->SetFAP(fap, frame.value(fap));
    face->Update();
  }
}

void memcpyOfOutput(benchmark::State& state) {
  const size_t bytes = 2 * 3 * sizeof(float) * FrameSurface::usualRows * (FrameSurface::usualColumns + 1);
  std::vector<char> from(bytes, 1), to(bytes, 2);
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), bytes);
    benchmark::ClobberMemory();
  }
}

}  // namespace

BENCHMARK(frameToCurves);
BENCHMARK_CAPTURE(frameToSurface, fourCurve, std::string("four-curve"));
BENCHMARK_CAPTURE(frameToSurface, spline, std::string("spline"));
BENCHMARK_CAPTURE(thousandFrames, fourCurve, std::string("four-curve"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(thousandFrames, spline, std::string("spline"))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(frameThroughPipeline, fourCurve, std::string("four-curve"));
BENCHMARK_CAPTURE(frameThroughPipeline, spline, std::string("spline"));
BENCHMARK(memcpyOfOutput);
