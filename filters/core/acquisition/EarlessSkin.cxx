#include "EarlessSkin.h"

#include <algorithm>
#include <cmath>

#include "Degree.h"
#include "SmoothStep.h"

namespace mien {

namespace {

constexpr double frontEnd = 60.0 * degree;     // the mesh itself counts up to here
constexpr double sideBegin = 80.0 * degree;    // an ear is taken off wholly from here; ears begin at about 90
constexpr int columnCount = 180;               // 2 degrees each
constexpr double rowHeight = 2.0;              // mm
constexpr int earHalfWidth = 10;               // columns: the window of 42 degrees is wider than any ear
constexpr double earZoneEnd = 150.0 * degree;  // the back of the head is left as it is
constexpr double smoothing = 3.0;              // standard deviation in columns and rows
constexpr double earHeight = 2.5;              // mm that an ear stands out at least
constexpr int earMargin = 4;                   // columns and rows around an ear that go with it

int wrapped(int column) {
  return (column + columnCount) % columnCount;
}

template <class Pick>
Eigen::VectorXd overWindow(const Eigen::VectorXd& row, Pick pick) {
  Eigen::VectorXd result(columnCount);
  for (int c = 0; c < columnCount; ++c) {
    result[c] = row[c];
    for (int k = -earHalfWidth; k <= earHalfWidth; ++k) result[c] = pick(result[c], row[wrapped(c + k)]);
  }
  return result;
}

double columnAzimuth(int column) {
  return -M_PI + 2.0 * degree * column;
}

/// Morphological opening beside the head: spikes narrower than the window go, everything wider stays.
Eigen::VectorXd opened(const Eigen::VectorXd& row) {
  const Eigen::VectorXd eroded = overWindow(row, [](double a, double b) { return std::min(a, b); });
  Eigen::VectorXd result = overWindow(eroded, [](double a, double b) { return std::max(a, b); });
  for (int c = 0; c < columnCount; ++c)
    if (std::abs(columnAzimuth(c)) > earZoneEnd) result[c] = row[c];
  return result;
}

/// Gaussian mean of the finite values of `map` around a cell, along one direction.
Eigen::MatrixXd smoothed(const Eigen::MatrixXd& map, int rowStep, int columnStep) {
  const int reach = static_cast<int>(3.0 * smoothing);
  Eigen::MatrixXd result = map;
  for (int r = 0; r < map.rows(); ++r)
    for (int c = 0; c < columnCount; ++c) {
      double sum = 0.0, weight = 0.0;
      for (int k = -reach; k <= reach; ++k) {
        const int row = std::clamp<int>(r + k * rowStep, 0, static_cast<int>(map.rows()) - 1);
        const double value = map(row, wrapped(c + k * columnStep));
        const double w = std::isfinite(value) ? std::exp(-0.5 * k * k / (smoothing * smoothing)) : 0.0;
        sum += w > 0.0 ? w * value : 0.0;
        weight += w;
      }
      result(r, c) = sum / weight;
    }
  return result;
}

/// 1 where skin stands out beside the head and within a margin of there, else 0.
Eigen::MatrixXd earsOf(const Eigen::MatrixXd& height) {
  Eigen::MatrixXd ears = Eigen::MatrixXd::Zero(height.rows(), columnCount);
  for (int r = 0; r < height.rows(); ++r)
    for (int c = 0; c < columnCount; ++c) {
      if (!(height(r, c) > earHeight)) continue;
      for (int i = std::max(r - earMargin, 0); i <= std::min<int>(r + earMargin, static_cast<int>(height.rows()) - 1);
           ++i)
        for (int j = -earMargin; j <= earMargin; ++j) ears(i, wrapped(c + j)) = 1.0;
    }
  return ears;
}

}  // namespace

EarlessSkin::EarlessSkin(const RadialSkin& skin, double low, double high) : skin_(skin), low_(low) {
  const int rows = std::max(2, static_cast<int>(std::ceil((high - low) / rowHeight)) + 1);
  map_.resize(rows, columnCount);
  Eigen::MatrixXd height(rows, columnCount);
  for (int r = 0; r < rows; ++r) {
    Eigen::VectorXd ring(columnCount);
    for (int c = 0; c < columnCount; ++c) ring[c] = skin.radius(columnAzimuth(c), low + r * rowHeight);
    map_.row(r) = opened(ring);
    height.row(r) = ring.transpose() - map_.row(r);
  }
  map_ = smoothed(smoothed(map_, 0, 1), 1, 0);
  const Eigen::MatrixXd ears = earsOf(height);
  ears_ = smoothed(smoothed(ears, 0, 1), 1, 0);
}

double EarlessSkin::mapped(const Eigen::MatrixXd& map, double azimuth, double y) const {
  const double row = std::clamp((y - low_) / rowHeight, 0.0, map.rows() - 1.0);
  const double column = (std::remainder(azimuth, 2.0 * M_PI) + M_PI) / (2.0 * degree);
  const int r = std::min(static_cast<int>(row), static_cast<int>(map.rows()) - 2), c = static_cast<int>(column);
  const double s = row - r, t = column - c;
  const auto along = [&](int i) { return (1.0 - t) * map(i, wrapped(c)) + t * map(i, wrapped(c + 1)); };
  return (1.0 - s) * along(r) + s * along(r + 1);
}

double EarlessSkin::radius(double azimuth, double y) const {
  const double aside = std::abs(std::remainder(azimuth, 2.0 * M_PI));
  const double skin = skin_.filledRadius(azimuth, y);
  const double w = smoothStep((aside - frontEnd) / (sideBegin - frontEnd)) * smoothStep(mapped(ears_, azimuth, y));
  if (w <= 0.0 && std::isfinite(skin)) return skin;
  const double smooth = aside > frontEnd ? mapped(map_, azimuth, y) : skin;
  return w >= 1.0 || !std::isfinite(skin) ? smooth : (1.0 - w) * skin + w * smooth;
}

}  // namespace mien
