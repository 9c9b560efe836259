#include <random>

#include "RegionMap.h"

using namespace mien;

TEST(FacialRegions, TheMapHasMirrorPairs) {
  const FacialRegions regions = regionMap();
  for (int region = 1; region <= 16; ++region) {
    const Eigen::Vector2d centre = regions.centre(region), other = regions.centre(regions.mirrored(region));
    EXPECT_EQ(other, Eigen::Vector2d(-centre.x(), centre.y())) << regions.name(region);
    EXPECT_EQ(regions.nearest(centre), region);
  }
}

TEST(FacialRegions, WeightsAreAPartitionOfUnityAndHardInside) {
  const FacialRegions regions = regionMap();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-2.5, 2.5), y(-4.0, 2.0);
  int interior = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d point(x(random), y(random));
    const FacialRegions::Weights weights = regions.weights(point);
    double sum = 0.0;
    for (const double weight : weights) {
      EXPECT_GE(weight, 0.0);
      sum += weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-14);
    const int nearest = regions.nearest(point);
    const double own = (regions.centre(nearest) - point).norm();
    double next = 100.0;
    for (int r = 1; r <= 16; ++r)
      if (r != nearest) next = std::min(next, (regions.centre(r) - point).norm());
    if (next - own < 0.5) continue;
    ++interior;
    EXPECT_EQ(weights[nearest - 1], 1.0);
  }
  EXPECT_GT(interior, 600);
}

TEST(FacialRegions, WeightsAreContinuous) {
  const FacialRegions regions = regionMap();
  for (const FaceSide side : {FaceSide(), FaceSide{1.0, 0.0}, FaceSide{-0.4, 0.3}, FaceSide{0.0, -1.0}}) {
    const double step = 1e-3;
    for (double y = -4.0; y < 2.0; y += 0.37)
      for (double x = -2.5; x < 2.5; x += step) {
        const auto a = regions.weights({x, y}, side), b = regions.weights({x + step, y}, side);
        for (int i = 0; i < 16; ++i) ASSERT_LT(std::abs(a[i] - b[i]), 0.02) << x << " " << y;
      }
  }
}

TEST(FacialRegions, TheLipsAreApartWhereTheyMeet) {
  const FacialRegions regions = regionMap();
  for (const double y : {-2.0, -2.3, -2.6})
    for (const double x : {-0.3, 0.0, 0.3}) {
      EXPECT_EQ(regions.nearest({x, y}, {1.0, 0.0}), 12) << x << " " << y;
      EXPECT_EQ(regions.nearest({x, y}, {-1.0, 0.0}), 13) << x << " " << y;
      EXPECT_EQ(regions.weights({x, y}, {1.0, 0.0})[12], 0.0);
      EXPECT_EQ(regions.weights({x, y}, {-1.0, 0.0})[11], 0.0);
    }
}

TEST(FacialRegions, FadesOutsideTheFaceAndBehindIt) {
  const FacialRegions regions = regionMap();
  EXPECT_EQ(regions.outlineWeight({0.0, -3.5}), 1.0);
  EXPECT_EQ(regions.outlineWeight({-2.05, 0.0}), 1.0);
  EXPECT_GT(regions.outlineWeight({0.0, -3.85}), 0.9) << "the outline itself";
  EXPECT_EQ(regions.outlineWeight({0.0, -6.0}), 0.0);
  EXPECT_EQ(regions.outlineWeight({0.0, 4.0}), 0.0);
  EXPECT_EQ(regions.depthWeight(0.5), 1.0);
  EXPECT_EQ(regions.depthWeight(-1.4), 1.0);
  EXPECT_NEAR(regions.depthWeight(-1.7), 0.5, 1e-12);
  EXPECT_EQ(regions.depthWeight(-2.0), 0.0) << "the ears";
}

TEST(FacialRegions, BeyondTheOutlinePointsFollowIt) {
  const FacialRegions regions = regionMap();
  for (const double angle : {0.1, 0.8, 1.6, 2.9, 4.0, 4.7, 5.5}) {
    const Eigen::Vector2d centre(0.0, -1.05), direction(std::cos(angle), std::sin(angle));
    double before = 0.0;
    for (double distance = 0.0; distance < 8.0; distance += 0.01) {
      const Eigen::Vector2d point = centre + distance * direction, followed = regions.followed(point);
      const double kept = (followed - centre).norm();
      EXPECT_LE(kept, distance + 1e-12);
      EXPECT_NEAR(kept, direction.dot(followed - centre), 1e-12) << "in the same direction";
      EXPECT_TRUE(regions.covers(centre + (1.0 - 1e-9) * (followed - centre)));
      EXPECT_GE(kept, before - 1e-9) << "never back";
      EXPECT_LE(kept - before, 0.01 + 1e-9) << "nowhere faster than the point";
      if (regions.covers(centre + (point - centre) / 0.9)) {
        EXPECT_EQ(followed, point);
      }
      before = kept;
    }
  }
}

TEST(FacialRegions, MirroredTwiceIsTheTable) {
  const FacialRegions regions = regionMap();
  DeformationTable table;
  for (int i = 0; i < 16; ++i)
    for (int k = 0; k < 12; ++k) table.maps[i].coefficients(k / 6, k % 6) = std::sin(13.0 * i + k);
  const DeformationTable once = regions.mirrored(table), twice = regions.mirrored(once);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(twice.maps[i].coefficients, table.maps[i].coefficients);
  EXPECT_NE(once.maps[0].coefficients, table.maps[0].coefficients);
}

TEST(FacialRegions, RefusesAMapThatIsNone) {
  FacialRegions regions = regionMap();
  const std::string good = readDataFile("deformation/regions.json");
  const auto fault = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return regions.parse(text.replace(text.find(from), from.size(), to));
  };
  EXPECT_NE(fault("\"version\": 1", "\"version\": 2").find("version"), std::string::npos);
  EXPECT_NE(fault("\"region\": 2,", "\"region\": 1,").find("given twice"), std::string::npos);
  EXPECT_NE(fault("\"region\": 2,", "\"region\": 17,").find("1 to 16"), std::string::npos);
  EXPECT_NE(fault("\"mirror\": 2", "\"mirror\": 3").find("mirror"), std::string::npos);
  EXPECT_NE(fault("\"blend\": 0.5", "\"blend\": -1").find("blend"), std::string::npos);
  EXPECT_NE(fault("\"begin\": 0.9", "\"begin\": -1").find("begin"), std::string::npos);
  EXPECT_NE(fault("\"radius\": 2.8", "\"radius\": 0").find("radius"), std::string::npos);
  EXPECT_EQ(fault("\"below\": {\"radius\": 2.8, \"exponent\": 2.0}, \"begin\": 0.9, ", ""), "")
      << "both may be left out";
  EXPECT_EQ(regions.parse(good), "");
  EXPECT_NE(regions.parse("{").find("region map"), std::string::npos);
  EXPECT_EQ(regions.nearest({0.0, -3.4}), 16) << "a refused map must leave what was there";
}
