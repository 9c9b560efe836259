/// From FAP frames to curves and surfaces, beside memcpy of the same output in the same run.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>

#include "AnimationData.h"
#include "BoundaryCurveData.h"
#include "FAPParser.h"
#include "FAPTable.h"
#include "FAPWriter.h"
#include "FaceAnimator.h"
#include "FaceSurface.h"
#include "PDESurface.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"

using namespace mien;

namespace {

constexpr int rows = 56, columns = 40;

FaceCurves genericFace() {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  FaceCurves face;
  readFaceCurves(reader->GetOutput(), face);
  return face;
}

FaceAnimator genericAnimator() {
  AnimationTable table;
  readAnimationTable("", table);
  FaceAnimator animator;
  animator.bind(genericFace(), table);
  return animator;
}

/// The frames of a long movement: a few FAPs of every region, never the same twice.
FAPFrame movingFrame(int index) {
  FAPFrame frame;
  for (const int fap : {19, 20, 31, 32, 33, 34, 41, 42, 51, 52, 53, 54, 59, 60})
    frame.setValue(fap, 120.0 * std::sin(0.1 * index + fap));
  return frame;
}

void frameToCurves(benchmark::State& state) {
  FaceAnimator animator = genericAnimator();
  int index = 0;
  for (auto _ : state) benchmark::DoNotOptimize(animator.animate(movingFrame(index++)).points.data());
}

void frameToSurface(benchmark::State& state, const std::string& scheme) {
  FaceAnimator animator = genericAnimator();
  FaceSurfaceOptions options;
  options.scheme = scheme;
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(columns + 1, 0.0, 2.0 * M_PI);
  PDESurface<float> surface(facePieces(options, RowLayout(rows, false)), HarmonicSplit(40, 5, true),
                            FaceLayout::curveCount, v);
  RowMajor<float> points(rows, v.size() * 3), normals = points;
  const auto grid = [](RowMajor<float>& m) { return PDESurface<float>::Grid(m.data(), m.rows(), m.cols()); };
  int index = 0;
  for (auto _ : state) {
    surface.setCurves(animator.animate(movingFrame(index++)));
    surface.evaluateWithNormals(0, grid(points), grid(normals));
    benchmark::ClobberMemory();
  }
}

/// A file of 1,000 frames to curves and to a surface of 56 x 40 with normals: under 0.25 s in one thread is asked for.
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
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(columns + 1, 0.0, 2.0 * M_PI);
  FaceSurfaceOptions options;
  options.scheme = scheme;
  PDESurface<float> surface(facePieces(options, RowLayout(rows, false)), HarmonicSplit(40, 5, true),
                            FaceLayout::curveCount, v);
  RowMajor<float> points(rows, v.size() * 3), normals = points;
  const auto grid = [](RowMajor<float>& m) { return PDESurface<float>::Grid(m.data(), m.rows(), m.cols()); };
  for (auto _ : state) {
    FAPSequence played;
    if (parseFAP(text, played)) return state.SkipWithError("the file cannot be read");
    for (const FAPFrame& frame : played.frames) {
      surface.setCurves(animator.animate(frame));
      surface.evaluateWithNormals(0, grid(points), grid(normals));
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
  const size_t bytes = 2 * 3 * sizeof(float) * rows * (columns + 1);
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
