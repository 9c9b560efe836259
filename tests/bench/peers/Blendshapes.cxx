/// 53 linear blendshapes of the same vertices in single precision, as most programs animate a face; with the normals
/// that such a program makes from its polygons, and without.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <cmath>

#include "FrameSurface.h"
#include "MovingFace.h"

using namespace mien;

namespace {

constexpr int shapeCount = 53, firstFAP = 3;
constexpr int rows = FrameSurface::usualRows, columns = FrameSurface::usualColumns + 1;

using Vertices = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

class Blendshapes {
 public:
  Blendshapes() : weights_(shapeCount), moved_(rows * columns, 3), normals_(rows * columns, 3) {
    FaceAnimator animator = genericAnimator();
    FrameSurface surface("four-curve");
    neutral_ = shape(animator, surface, FAPFrame());
    differences_.resize(neutral_.size(), shapeCount);
    for (int i = 0; i < shapeCount; ++i) {
      FAPFrame frame;
      frame.setValue(firstFAP + i, 200.0);
      differences_.col(i) = shape(animator, surface, frame) - neutral_;
    }
  }

  void move(int frame) {
    for (int i = 0; i < shapeCount; ++i) weights_[i] = static_cast<float>(std::sin(0.1 * frame + i));
    Eigen::Map<Eigen::VectorXf> all(moved_.data(), moved_.size());
    all = neutral_;
    all.noalias() += differences_ * weights_;
  }

  /// The mean of the polygons around each vertex, weighted by area.
  void makeNormals() {
    normals_.setZero();
    for (int row = 0; row + 1 < rows; ++row)
      for (int column = 0; column + 1 < columns; ++column) addCell(row * columns + column);
    normals_.rowwise().normalize();
  }

 private:
  static Eigen::VectorXf shape(FaceAnimator& animator, FrameSurface& surface, const FAPFrame& frame) {
    surface.update(animator.animate(frame));
    return Eigen::Map<const Eigen::VectorXf>(surface.points().data(), surface.points().size());
  }

  void addCell(int a) {
    const int b = a + 1, c = a + columns + 1, d = a + columns;
    const Eigen::RowVector3f first = moved_.row(c) - moved_.row(a), second = moved_.row(d) - moved_.row(b);
    const Eigen::RowVector3f normal = first.cross(second);
    for (const int corner : {a, b, c, d}) normals_.row(corner) += normal;
  }

  Eigen::VectorXf neutral_, weights_;
  Eigen::MatrixXf differences_;
  Vertices moved_, normals_;
};

void blendshapes(benchmark::State& state, bool withNormals) {
  Blendshapes face;
  int frame = 0;
  for (auto _ : state) {
    face.move(++frame);
    if (withNormals) face.makeNormals();
    benchmark::ClobberMemory();
  }
}

}  // namespace

BENCHMARK_CAPTURE(blendshapes, points, false)->Name("peer/blendshapes/points");
BENCHMARK_CAPTURE(blendshapes, normals, true)->Name("peer/blendshapes/normals");
