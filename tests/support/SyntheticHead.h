#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "FaceLandmarks.h"
#include "TriangleMesh.h"

/// Heads of known shape: the radius around a vertical axis as a function of azimuth and height.
struct SyntheticHead {
  static constexpr double degree = M_PI / 180.0;
  mien::HeadAxis axis{0.0, 25.0};
  std::function<double(double azimuth, double y)> radius;

  Eigen::Vector3d at(double azimuth, double y) const { return axis.point(azimuth, y, radius(azimuth, y)); }

  /// A vertex every 2 degrees of azimuth and every 2 mm of height.
  mien::TriangleMesh mesh(int low = -100, int high = 130) const {
    constexpr int columns = 180, step = 2;
    const int rows = (high - low) / step + 1;
    mien::TriangleMesh result;
    result.vertices.resize(rows * columns, 3);
    result.triangles.resize((rows - 1) * columns * 2, 3);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c)
        result.vertices.row(r * columns + c) = at((2 * c - 180) * degree, low + step * r);
    for (int r = 0; r + 1 < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const int a = r * columns + c, b = r * columns + (c + 1) % columns;
        result.triangles.row(2 * a) << a, b, b + columns;
        result.triangles.row(2 * a + 1) << a, b + columns, a + columns;
      }
    return result;
  }

  /// Landmarks on the head with the azimuths (degrees) and heights (mm) of an average face, mirrored exactly.
  mien::FaceLandmarks landmarks() const;
};

/// An ellipse around the axis, narrowing a little towards top and bottom.
inline SyntheticHead ellipticHead() {
  SyntheticHead head;
  head.radius = [](double azimuth, double y) {
    const double ring = 1.0 / std::hypot(std::sin(azimuth) / 75.0, std::cos(azimuth) / 90.0);
    return ring * (1.0 - 1e-5 * y * y);
  };
  return head;
}

inline mien::FaceLandmarks SyntheticHead::landmarks() const {
  // landmark, its mirror image, azimuth of the latter (the subject's left), height
  struct Pair {
    int right, left;
    double azimuth, y;
  };
  static constexpr std::array<Pair, 37> pairs = {{
      {0, 16, 80, 36},    {1, 15, 78, 14},  {2, 14, 72, -5},  {3, 13, 66, -23},  {4, 12, 56, -44},  {5, 11, 41, -61},
      {6, 10, 26, -68},   {7, 9, 11, -71},  {8, 8, 0, -74},   {17, 26, 47, 52},  {18, 25, 37, 60},  {19, 24, 27, 62},
      {20, 23, 17, 62},   {21, 22, 8, 59},  {27, 27, 0, 37},  {28, 28, 0, 26},   {29, 29, 0, 16},   {30, 30, 0, 5},
      {31, 35, 8, -11},   {32, 34, 4, -11}, {33, 33, 0, -11}, {36, 45, 35, 34},  {37, 44, 29, 39},  {38, 43, 21, 39.5},
      {39, 42, 15, 33},   {40, 47, 21, 31}, {41, 46, 29, 31}, {48, 54, 18, -34}, {49, 53, 11, -27}, {50, 52, 4, -23},
      {51, 51, 0, -24},   {57, 57, 0, -42}, {58, 56, 7, -42}, {59, 55, 12, -39}, {60, 64, 16, -34}, {61, 63, 6.5, -32},
      {67, 65, 7, -32.4},
  }};
  mien::FaceLandmarks result;
  for (const Pair& pair : pairs) {
    const Eigen::Vector3d left = at(pair.azimuth * degree, pair.y);
    result.points.row(pair.left) = left;
    result.points.row(pair.right) << -left.x(), left.y(), left.z();
  }
  result.points.row(62) = at(0.0, -32.0);
  result.points.row(66) = at(0.0, -32.4);
  return result;
}
