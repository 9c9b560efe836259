#include "RegionMap.h"
#include "TableDeformation.h"
#include "TableText.h"

using namespace mien;

namespace {

PupilNormalisation pupils() {
  PupilNormalisation result;
  EXPECT_EQ(result.set({31.0, 36.0, 82.0}, {-31.0, 36.0, 82.0}), "");
  return result;
}

/// A grid over the face in mm, `side` of the lips for all.
std::vector<DeformationPoint> grid(double step) {
  std::vector<DeformationPoint> points;
  for (double y = -170.0; y <= 170.0; y += step)
    for (double x = -150.0; x <= 150.0; x += step) {
      DeformationPoint point;
      point.position = {x, y, 90.0};
      points.push_back(point);
    }
  return points;
}

/// Regions that move apart, with quadratic parts.
DeformationTable unruly() {
  DeformationTable table;
  for (int i = 0; i < 16; ++i) {
    table.maps[i].coefficients(0, 5) = 0.1 * std::sin(5.0 * i);
    table.maps[i].coefficients(1, 5) = 0.1 * std::cos(5.0 * i);
    table.maps[i].coefficients(1, 0) = 0.2 * std::sin(3.0 * i);
  }
  table.largestDisplacement = 0.3;
  return table;
}

std::vector<Eigen::Vector2d> moves(const std::vector<DeformationPoint>& points, const DeformationTable& table,
                                   bool smooth, double strength = 1.0) {
  const TableDeformation deformation(points, pupils(), regionMap(), smooth);
  std::vector<Eigen::Vector2d> result(points.size());
  deformation.displacements(table, fittedDisplacement(table, regionMap()), strength, 0, points.size(), result.data());
  return result;
}

}  // namespace

TEST(TableDeformation, TheIdentityMovesNothing) {
  for (const bool smooth : {false, true})
    for (const Eigen::Vector2d& move : moves(grid(7.0), DeformationTable(), smooth)) EXPECT_EQ(move.norm(), 0.0);
}

TEST(TableDeformation, NothingMovesFartherThanTheLimit) {
  double largest = 0.0;
  for (const Eigen::Vector2d& move : moves(grid(3.0), unruly(), true)) largest = std::max(largest, move.norm());
  EXPECT_LE(largest, 1.5 * 0.3 * 31.0 + 1e-9);
  EXPECT_GT(largest, 0.3 * 31.0) << "else the limit is not tried";
}

TEST(TableDeformation, FarFromTheFaceNothingMoves) {
  const auto points = grid(5.0);
  const auto result = moves(points, unruly(), true);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::abs(points[i].position.x()) > 116.0 || points[i].position.y() < -140.0) {
      EXPECT_EQ(result[i].norm(), 0.0);
    }
}

TEST(TableDeformation, NothingRunsAwayBeyondTheOutline) {
  const FacialRegions regions = regionMap();
  DeformationTable table = unruly();
  table.largestDisplacement = 10.0;  // no limit
  const auto points = grid(4.0);
  const auto result = moves(points, table, true);
  double within = 0.0, beyond = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool face = regions.covers(pupils().apply(points[i].position).head<2>());
    (face ? within : beyond) = std::max(face ? within : beyond, result[i].norm());
  }
  EXPECT_GT(beyond, 0.0);
  EXPECT_LE(beyond, within) << "quadratics grow with the square of the distance";
}

TEST(TableDeformation, SmoothIsContinuousWhereHardTears) {
  const auto jump = [](bool smooth, double step) {
    std::vector<DeformationPoint> line;
    for (double y = -110.0; y < 90.0; y += step) line.push_back({{9.0, y, 90.0}, {}});
    const auto result = moves(line, unruly(), smooth);
    double largest = 0.0;
    for (std::size_t i = 1; i < result.size(); ++i) largest = std::max(largest, (result[i] - result[i - 1]).norm());
    return largest;
  };
  EXPECT_LT(jump(true, 0.01), 0.15 * jump(true, 0.1));
  EXPECT_GT(jump(false, 0.01), 1.0);
}

TEST(TableDeformation, SmoothEqualsHardInTheInteriors) {
  const FacialRegions regions = regionMap();
  std::vector<DeformationPoint> centres;
  for (int region = 1; region <= 16; ++region) {
    const Eigen::Vector2d centre = regions.centre(region);
    centres.push_back({pupils().invert({centre.x(), centre.y(), 0.0}), {}});
  }
  const auto smooth = moves(centres, unruly(), true), hard = moves(centres, unruly(), false);
  for (std::size_t i = 0; i < centres.size(); ++i) EXPECT_LT((smooth[i] - hard[i]).norm(), 1e-12) << i + 1;
}

TEST(TableDeformation, StrengthScales) {
  const auto points = grid(11.0);
  const auto full = moves(points, unruly(), true), half = moves(points, unruly(), true, 0.5);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((0.5 * full[i] - half[i]).norm(), 1e-12);
}

TEST(TableDeformation, TheLipsPart) {
  DeformationTable table;
  table.maps[11].coefficients(1, 5) = 0.1;
  table.maps[12].coefficients(1, 5) = -0.2;
  table.largestDisplacement = 0.2;
  const Eigen::Vector3d lip = pupils().invert({0.0, -2.2, 0.0});
  const auto result = moves({{lip, {1.0, 0.0}}, {lip, {-1.0, 0.0}}}, table, true);
  EXPECT_NEAR(result[0].y(), 3.1, 0.15) << "the border with the nose is near";
  EXPECT_NEAR(result[1].y(), -6.2, 1e-9);
}

/// Where the determinant of p' by p is negative, the skin folds over itself.
TEST(TableDeformation, NoMeanTableFoldsTheFace) {
  constexpr double step = 0.05, half = 0.01;
  for (const char* name : {"joy", "sadness", "anger", "fear", "disgust", "surprise", "obaid2009_smile"}) {
    DeformationTable table;
    ASSERT_EQ(parseTable(readDataFile("deformation/" + std::string(name) + ".csv"), table), "");
    for (const double side : {-1.0, 0.0, 1.0}) {
      // On 12 heads sides beyond 0.8 end at x = 0.58, the upper lip's at y = -2.45 and the lower one's at -1.99.
      const double aside = side == 0.0 ? 2.6 : 0.65, below = side == 0.0 ? -4.0 : (side > 0.0 ? -2.5 : -2.9),
                   above = side == 0.0 ? 3.0 : (side > 0.0 ? -1.6 : -1.95);
      std::vector<DeformationPoint> around;
      for (double y = below; y < above; y += step)
        for (double x = -aside; x < aside; x += step)
          for (const auto& [dx, dy] : {std::pair(half, 0.0), {-half, 0.0}, {0.0, half}, {0.0, -half}})
            around.push_back({pupils().invert({x + dx, y + dy, 0.0}), {side, 0.0}});
      const auto moved = moves(around, table, true);
      double least = 1.0;
      for (std::size_t i = 0; i < around.size(); i += 4) {
        const auto slope = [&](std::size_t a, std::size_t b) {
          const Eigen::Vector2d before = (around[a].position - around[b].position).head<2>();
          return ((before + moved[a] - moved[b]) / before.norm()).eval();
        };
        const Eigen::Vector2d along = slope(i, i + 1), up = slope(i + 2, i + 3);
        least = std::min(least, along.x() * up.y() - along.y() * up.x());
      }
      EXPECT_GT(least, 0.03) << name << ", side " << side;
      if (side == 0.0) {
        EXPECT_LT(least, 0.99) << name << " does move";
      }
    }
  }
}
