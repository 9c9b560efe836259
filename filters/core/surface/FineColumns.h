#pragma once

#include <Eigen/Core>

namespace mien {

constexpr int columnsPerSample = 10;

/// Row i interpolates the K samples of a curve at v = 2 pi i / (10 K): what a curve does between its samples.
Eigen::MatrixXd fineColumns(int pointsPerCurve);

}  // namespace mien
