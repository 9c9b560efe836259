/// vtkThinPlateSplineTransform moves the points of a surface as 68 control points move: the direct parameterisation
/// that the face of boundary curves replaces. Points only: normals would come on top.
#include <benchmark/benchmark.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkThinPlateSplineTransform.h>

#include <vector>

#include "FrameSurface.h"
#include "MovingFace.h"

using namespace mien;

namespace {

constexpr int controlCount = 68;
constexpr int movements = 16;  // made beforehand, so that only the spline is measured

/// Samples of the curves as far from each other as can be: no two of them coincide, which no spline would bear.
std::vector<int> controlSamples(const ClosedCurves::Points& points) {
  std::vector<int> chosen{0};
  Eigen::VectorXd distances = (points.rowwise() - points.row(0)).rowwise().squaredNorm();
  while (static_cast<int>(chosen.size()) < controlCount) {
    Eigen::Index furthest;
    distances.maxCoeff(&furthest);
    chosen.push_back(static_cast<int>(furthest));
    distances = distances.cwiseMin((points.rowwise() - points.row(furthest)).rowwise().squaredNorm());
  }
  return chosen;
}

vtkSmartPointer<vtkPoints> controlPoints(const ClosedCurves::Points& points, const std::vector<int>& samples) {
  auto controls = vtkSmartPointer<vtkPoints>::New();
  controls->SetDataTypeToDouble();
  for (const int sample : samples) controls->InsertNextPoint(points(sample, 0), points(sample, 1), points(sample, 2));
  return controls;
}

vtkSmartPointer<vtkPoints> neutralSurface(const ClosedCurves& curves) {
  FrameSurface surface("four-curve");
  surface.update(curves);
  auto points = vtkSmartPointer<vtkPoints>::New();
  const Eigen::Map<const RowMajor<float>> all(surface.points().data(), surface.points().size() / 3, 3);
  for (const auto& point : all.rowwise()) points->InsertNextPoint(point[0], point[1], point[2]);
  return points;
}

std::vector<vtkSmartPointer<vtkPoints>> movedControls(const std::vector<int>& samples) {
  FaceAnimator animator = genericAnimator();
  std::vector<vtkSmartPointer<vtkPoints>> moved;
  for (int i = 0; i < movements; ++i) moved.push_back(controlPoints(animator.animate(movingFrame(i)).points, samples));
  return moved;
}

/// @param moves  whether the control points are set each time, as in an animation
void thinPlate(benchmark::State& state, bool moves) {
  const FaceCurves face = genericFace();
  const std::vector<int> samples = controlSamples(face.curves.points);
  const auto controls = movedControls(samples);
  const auto surface = neutralSurface(face.curves);
  vtkNew<vtkThinPlateSplineTransform> spline;
  spline->SetBasisToR();  // of three dimensions
  spline->SetSourceLandmarks(controlPoints(face.curves.points, samples));
  spline->SetTargetLandmarks(controls.front());
  spline->Update();
  vtkNew<vtkPoints> moved;
  size_t frame = 0;
  for (auto _ : state) {
    if (moves) spline->SetTargetLandmarks(controls[++frame % controls.size()]);
    moved->Reset();
    spline->TransformPoints(surface, moved);
    benchmark::ClobberMemory();
  }
}

}  // namespace

BENCHMARK_CAPTURE(thinPlate, moving, true)->Name("peer/thinPlate/moving");
BENCHMARK_CAPTURE(thinPlate, still, false)->Name("peer/thinPlate/still");
