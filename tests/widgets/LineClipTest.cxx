#include <gtest/gtest.h>

#include "LineClip.h"

namespace {

const QRectF box(0.0, 0.0, 10.0, 10.0);

QPolygonF polygon(const QVector<QPointF>& points) {
  return QPolygonF(points);
}

TEST(LineClip, WhatLiesInsideIsKeptAsItIs) {
  const QPolygonF line = polygon({{1, 1}, {5, 9}, {9, 1}});
  const auto parts = mien::clippedLine(line, box);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0], line);
}

TEST(LineClip, ALineThatLeavesAndComesBackHasTwoParts) {
  const auto parts = mien::clippedLine(polygon({{2, 5}, {2, 15}, {8, 15}, {8, 5}}), box);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0], polygon({{2, 5}, {2, 10}}));
  EXPECT_EQ(parts[1], polygon({{8, 10}, {8, 5}}));
}

TEST(LineClip, ALineThroughIsCutAtBothSides) {
  const auto parts = mien::clippedLine(polygon({{-10, 5}, {20, 5}}), box);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].front().x(), 0.0, 1e-12);
  EXPECT_NEAR(parts[0].back().x(), 10.0, 1e-12);
}

TEST(LineClip, NothingIsLeftOfALineOutside) {
  EXPECT_TRUE(mien::clippedLine(polygon({{-5, -5}, {-1, 20}}), box).empty());
  EXPECT_TRUE(mien::clippedLine(polygon({{11, 0}, {11, 10}}), box).empty());
}

}  // namespace
