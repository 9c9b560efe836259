/// The PDE on one patch of 56 x 40 points by finite differences and Eigen's sparse LU, checked against an exact
/// solution.
#include <benchmark/benchmark.h>

#include <Eigen/SparseLU>
#include <cmath>

#include "BiharmonicGrid.h"
#include "FrameSurface.h"

namespace {

constexpr double smoothing = 1.0;

/// S = (e^(a u) cos v, e^(a u) sin v, u): solves the PDE exactly.
Eigen::RowVector3d exact(double u, double v) {
  const double radius = std::exp(smoothing * u);
  return {radius * std::cos(v), radius * std::sin(v), u};
}

Eigen::RowVector3d exactSlope(double u, double v) {
  Eigen::RowVector3d slope = smoothing * exact(u, v);
  slope[2] = 1.0;
  return slope;
}

class Patch {
 public:
  Patch() : grid_(rows, columns, smoothing), edges_(4 * columns, 3) {
    for (int j = 0; j < columns; ++j) {
      const double v = grid_.v(j);
      edges_.row(j) = exact(0.0, v);
      edges_.row(columns + j) = exact(1.0, v);
      edges_.row(2 * columns + j) = exactSlope(0.0, v);
      edges_.row(3 * columns + j) = exactSlope(1.0, v);
    }
  }

  void factorise() {
    solver_.analyzePattern(grid_.matrix());
    solver_.factorize(grid_.matrix());
  }

  void solve() { solution_ = solver_.solve(grid_.edges() * edges_); }

  double largestError() const {
    double largest = 0.0;
    for (int row = 1; row + 1 < rows; ++row)
      for (int j = 0; j < columns; ++j)
        largest = std::max(
            largest, (solution_.row((row - 1) * columns + j) - exact(grid_.u(row), grid_.v(j))).cwiseAbs().maxCoeff());
    return largest;
  }

 private:
  static constexpr int rows = FrameSurface::usualRows, columns = FrameSurface::usualColumns;
  BiharmonicGrid grid_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> edges_, solution_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver_;
};

void expectSolved(benchmark::State& state, const Patch& patch) {
  state.counters["error"] = patch.largestError();
  if (!(patch.largestError() < 1e-2)) state.SkipWithError("the differences do not solve the PDE");
}

void factorisation(benchmark::State& state) {
  Patch patch;
  for (auto _ : state) patch.factorise();
  patch.solve();
  expectSolved(state, patch);
}

/// New curves, the factors kept.
void solution(benchmark::State& state) {
  Patch patch;
  patch.factorise();
  for (auto _ : state) patch.solve();
  expectSolved(state, patch);
}

}  // namespace

BENCHMARK(factorisation)->Name("peer/finiteDifferences/factorisation")->Unit(benchmark::kMillisecond);
BENCHMARK(solution)->Name("peer/finiteDifferences/solution")->Unit(benchmark::kMicrosecond);
