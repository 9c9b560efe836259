#include <gtest/gtest.h>

#include "PolygonCounts.h"

using namespace mien;

namespace {

void expectCounts(const PolygonCounts& counts, int triangles, int quads, int larger) {
  EXPECT_EQ(counts.triangles, triangles);
  EXPECT_EQ(counts.quads, quads);
  EXPECT_EQ(counts.larger, larger);
}

}  // namespace

TEST(PolygonCounts, AreThoseOfTheFile) {
  expectCounts(
      countPolygons("v 0 0 0\r\nf 1 2 3 \r\nf 1/2 2/3/4 3//1 4 # a quad\nf 1 2 3 4 5\nf 1 2 3\nf 1 2\n", ".obj"), 2, 1,
      1);
  expectCounts(countPolygons("OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n4 0 1 2 0\n", ".off"), 1, 1, 0);
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n";
  expectCounts(countPolygons(ply + "4 0 0 0 0\n6 0 0 0 0 0 0\n", ".ply"), 0, 1, 1);
  expectCounts(countPolygons(ply + "4 0 0 0 0\n", ".ply"), 0, 1, 0);
}

TEST(PolygonCounts, WhatCannotBeFollowedHasNone) {
  EXPECT_EQ(countPolygons("ply\nformat ascii 1.0\n", ".ply").sum(), 0);
  EXPECT_EQ(countPolygons("f 1 2 3\n", ".stl").sum(), 0);
  EXPECT_EQ(countPolygons("", ".obj").sum(), 0);
}
