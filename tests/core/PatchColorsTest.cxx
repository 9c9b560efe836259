#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "PatchColors.h"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d linearRgb(int color) {
  Vector3d rgb;
  for (int i = 0; i < 3; ++i) {
    const double c = ((color >> (16 - 8 * i)) & 0xff) / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// CIELAB under D65, from linear sRGB.
Vector3d lab(const Vector3d& rgb) {
  Matrix3d toXyz;
  toXyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Vector3d relative = (toXyz * rgb).cwiseQuotient(Vector3d(0.95047, 1.0, 1.08883));
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const Vector3d g(f(relative[0]), f(relative[1]), f(relative[2]));
  return {116.0 * g[1] - 16.0, 500.0 * (g[0] - g[1]), 200.0 * (g[1] - g[2])};
}

struct Vision {
  std::string name;
  Matrix3d seen;  ///< of linear sRGB
};

/// Machado, Oliveira and Fernandes 2009, table 1, severity 1.
std::vector<Vision> visions() {
  std::vector<Vision> all = {
      {"usual", Matrix3d::Identity()}, {"protanopia", {}}, {"deuteranopia", {}}, {"tritanopia", {}}};
  all[1].seen << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  all[2].seen << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  all[3].seen << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  return all;
}

/// 2.3 is a difference just noticed; 15 is seen at a glance.
TEST(PatchColors, AreToldApartWithAndWithoutColourVision) {
  constexpr double leastDifference = 15.0;
  for (const Vision& vision : visions())
    for (size_t i = 0; i < mien::patchColors.size(); ++i)
      for (size_t k = 0; k < i; ++k) {
        const auto seen = [&](int color) { return lab((vision.seen * linearRgb(color)).cwiseMax(0.0).cwiseMin(1.0)); };
        const double difference = (seen(mien::patchColors[i]) - seen(mien::patchColors[k])).norm();
        EXPECT_GT(difference, leastDifference) << vision.name << " P" << i << " P" << k;
      }
}

}  // namespace
