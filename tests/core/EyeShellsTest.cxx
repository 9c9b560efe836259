#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "EyeShells.h"

using namespace mien;

namespace {

/// Parts of a mesh, each a ring of rings about a centre.
struct Parts {
  std::vector<Eigen::Vector3d> places;
  MeshEdges edges;

  void addEllipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii) {
    constexpr int rings = 8, around = 12;
    const int first = int(places.size());
    for (int i = 0; i < rings; ++i)
      for (int j = 0; j < around; ++j) {
        const double polar = 0.2 + 2.7 * i / (rings - 1), angle = 2.0 * M_PI * j / around;
        const Eigen::Vector3d p(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), std::cos(polar));
        places.push_back(centre + radii.cwiseProduct(p));
        const int own = first + i * around + j;
        edges.push_back({own, first + i * around + (j + 1) % around});
        if (i > 0) edges.push_back({own, own - around});
      }
  }

  long inEyes() const {
    MeshVertices vertices(places.size(), 3);
    for (std::size_t i = 0; i < places.size(); ++i) vertices.row(i) = places[i].transpose();
    const std::vector<bool> eyes = eyeShells(vertices, edges);
    return std::count(eyes.begin(), eyes.end(), true);
  }
};

constexpr long each = 96;  // vertices

}  // namespace

TEST(EyeShells, BothShellsOfAnEyeAndWhatLiesWithinBelongToIt) {
  Parts parts;
  parts.addEllipsoid({1.0, 0.0, -0.3}, {0.45, 0.45, 0.45});
  EXPECT_EQ(parts.inEyes(), each);
  parts.addEllipsoid({0.98, 0.02, -0.3}, {0.5, 0.5, 0.54});
  EXPECT_EQ(parts.inEyes(), 2 * each);
  parts.addEllipsoid({1.0, 0.0, 0.1}, {0.15, 0.15, 0.01});
  EXPECT_EQ(parts.inEyes(), 3 * each) << "an iris inside";
  parts.addEllipsoid({-1.1, 0.1, 20.0}, {0.5, 0.5, 0.5});
  EXPECT_EQ(parts.inEyes(), 4 * each) << "the pupils' depth may be unknown";
}

TEST(EyeShells, SkinEarringsGlassesAndNosesDoNot) {
  Parts parts;
  parts.addEllipsoid({0.0, 0.0, -3.0}, {2.5, 4.0, 3.0});
  parts.addEllipsoid({2.4, -1.5, -2.0}, {0.25, 0.25, 0.25});
  parts.addEllipsoid({1.0, 0.0, 0.5}, {0.7, 0.6, 0.05});
  parts.addEllipsoid({0.0, -1.0, 0.5}, {0.3, 0.3, 0.3});
  parts.addEllipsoid({1.0, 0.0, 0.0}, {0.05, 0.05, 0.05});
  EXPECT_EQ(parts.inEyes(), 0);
}
