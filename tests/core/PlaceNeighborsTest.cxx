#include <gtest/gtest.h>

#include <map>

#include "PlaceNeighbors.h"

using mien::PlaceNeighbors;
using mien::TriangleMesh;

namespace {

/// A square of two triangles with corners of their own: places 0 1 2 3 around it, joined across from 0 to 2.
TriangleMesh apart() {
  TriangleMesh mesh;
  mesh.vertices.resize(6, 3);
  mesh.vertices << 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 0, 0, 2, 1, 0, 0, 1, 0;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 3, 4, 5;
  return mesh;
}

std::map<int, double> weightsAround(int place, const PlaceNeighbors& neighbors) {
  std::map<int, double> weights;
  for (const auto& [next, weight] : neighbors.around(place)) weights[next] += weight;
  return weights;
}

}  // namespace

/// Of the edges the cotangents of the angles opposite; the diagonal of a rectangle, with right angles at either side,
/// has next to none.
TEST(PlaceNeighbors, VerticesAtOnePlaceAreOne) {
  const PlaceNeighbors neighbors(apart());
  EXPECT_EQ(neighbors.count(), 4);
  EXPECT_EQ(neighbors.placeOf(3), neighbors.placeOf(0));
  EXPECT_EQ(neighbors.placeOf(4), neighbors.placeOf(2));
  const auto weights = weightsAround(0, neighbors);
  ASSERT_EQ(weights.size(), 3u);
  EXPECT_NEAR(weights.at(1), 0.5, 1e-6);
  EXPECT_NEAR(weights.at(3), 2.0, 1e-6);
  EXPECT_NEAR(weights.at(2), 0.02, 1e-6) << "twice the least weight";
  EXPECT_EQ(weightsAround(1, neighbors).size(), 2u);
}

TEST(PlaceNeighbors, TrianglesWithoutAreaHaveFiniteWeightsAndNoPlaceIsItsOwnNeighbour) {
  TriangleMesh mesh = apart();
  mesh.triangles.row(1) << 0, 3, 2;
  const PlaceNeighbors neighbors(mesh);
  for (int place = 0; place < neighbors.count(); ++place)
    for (const auto& [next, weight] : neighbors.around(place)) {
      EXPECT_NE(next, place);
      EXPECT_GE(weight, 0.0099f);
      EXPECT_LE(weight, 10.0f);
    }
}

TEST(PlaceNeighbors, StoppedItHasNoNeighbours) {
  for (int last : {1, 2}) {
    int asked = 0;
    const PlaceNeighbors neighbors(apart(), [&](double) { return ++asked < last; });
    EXPECT_EQ(asked, last);
    for (int place = 0; place < neighbors.count(); ++place) EXPECT_TRUE(weightsAround(place, neighbors).empty());
  }
}
