#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "MotionTableText.h"
#include "PicturePlane.h"
#include "SurfaceContour.h"
#include "SurfaceOcclusion.h"
#include "SyntheticFace.h"
#include "VectorPicture.h"
#include "VectorScale.h"

namespace {

using mien::VectorSampling;

/// A sphere of radius 50 mm, poles up and down, wound outwards.
mien::TriangleMesh sphere(int rows = 40, int columns = 60, double radius = 50.0) {
  mien::TriangleMesh mesh;
  mesh.vertices.resize((rows + 1) * columns, 3);
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double latitude = M_PI * r / rows, longitude = 2.0 * M_PI * c / columns;
      mesh.vertices.row(r * columns + c) << radius * std::sin(latitude) * std::sin(longitude),
          radius * std::cos(latitude), radius * std::sin(latitude) * std::cos(longitude);
    }
  mesh.triangles.resize(2 * rows * columns, 3);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * columns + c, b = r * columns + (c + 1) % columns, below = columns;
      mesh.triangles.row(2 * (r * columns + c)) << a, a + below, b;
      mesh.triangles.row(2 * (r * columns + c) + 1) << b, a + below, b + below;
    }
  return mesh;
}

mien::MotionField sphereField(const Eigen::RowVector3d& move) {
  mien::MotionField field;
  field.surface = sphere();
  field.origins = field.surface.vertices;
  field.normals = field.surfaceNormals = field.origins.rowwise().normalized();
  field.vectors = move.replicate(field.origins.rows(), 1);
  field.columns = 60;
  for (long long i = 0; i < field.origins.rows(); ++i) field.ids.push_back(i);
  return field;
}

Eigen::Matrix<double, Eigen::Dynamic, 2> lattice(int side, double step) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> places(side * side, 2);
  for (int i = 0; i < side * side; ++i) places.row(i) << step * (i % side), step * (i / side);
  return places;
}

std::vector<int> numbers(int count) {
  std::vector<int> all(count);
  for (int i = 0; i < count; ++i) all[i] = i;
  return all;
}

}  // namespace

TEST(PicturePlane, IsOrthonormalAndRightHanded) {
  mien::PicturePlane plane;
  EXPECT_EQ(plane.look({3.0, 1.0, 2.0}, {0.0, 5.0, 0.0}), "");
  EXPECT_NEAR(plane.right.dot(plane.up), 0.0, 1e-15);
  EXPECT_NEAR((plane.right.cross(plane.up) - plane.out).norm(), 0.0, 1e-15);
  EXPECT_NEAR((plane.out - Eigen::Vector3d(3.0, 1.0, 2.0).normalized()).norm(), 0.0, 1e-15);
  EXPECT_GT(plane.up.y(), 0.0);
  EXPECT_NE(plane.look({0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}), "");
  EXPECT_NE(plane.look({0.0, 2.0, 0.0}, {0.0, 1.0, 0.0}), "");
}

TEST(SurfaceOcclusion, ASphereHidesItsBackAndWhatIsBehindIt) {
  const mien::TriangleMesh mesh = sphere();
  for (const Eigen::Vector3d& view :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 1), Eigen::Vector3d(-1, 0.5, 0.2)}) {
    mien::PicturePlane plane;
    plane.look(view, Eigen::Vector3d::UnitY());
    const mien::SurfaceOcclusion occlusion(mesh, plane);
    for (int i = 0; i < mesh.vertices.rows(); ++i) {
      const Eigen::Vector3d p = mesh.vertices.row(i);
      const double facing = p.normalized().dot(plane.out);
      EXPECT_TRUE(std::abs(facing) < 0.2 || occlusion.hides(p) == (facing < 0.0)) << p.transpose();
    }
    EXPECT_TRUE(occlusion.hides(-60.0 * plane.out));
    EXPECT_FALSE(occlusion.hides(60.0 * plane.out));
    EXPECT_FALSE(occlusion.hides(-60.0 * plane.out + 51.0 * plane.right));
  }
}

TEST(SurfaceOcclusion, NoSurfaceHidesNothing) {
  EXPECT_FALSE(mien::SurfaceOcclusion(mien::TriangleMesh(), mien::PicturePlane()).hides({0.0, 0.0, 0.0}));
}

TEST(SurfaceContour, TheSilhouetteOfASphereIsItsGreatCircleInOneLine) {
  mien::PicturePlane plane;
  plane.look({0.3, 0.2, 1.0}, Eigen::Vector3d::UnitY());
  const mien::TriangleMesh mesh = sphere();
  const auto lines = mien::silhouettes(mesh, mesh.vertices.rowwise().normalized(), plane);
  ASSERT_EQ(lines.size(), 1u);
  const auto& points = lines[0].points;
  EXPECT_EQ(points.row(0), points.row(points.rows() - 1));
  double length = 0.0;
  for (int i = 0; i < points.rows(); ++i) {
    EXPECT_NEAR(points.row(i).dot(plane.out), 0.0, 1e-10);
    EXPECT_NEAR(points.row(i).norm(), 50.0, 0.25);
    if (i > 0) length += (points.row(i) - points.row(i - 1)).norm();
  }
  EXPECT_NEAR(length, 2.0 * M_PI * 50.0, 1.5);
}

TEST(SurfaceContour, BordersAreTheRimsOfAnOpenSurface) {
  mien::TriangleMesh mesh = sphere();
  const auto normals = mien::vertexNormals(mesh);
  mesh.triangles = mesh.triangles.middleRows(60 * 2 * 5, 60 * 2 * 30).eval();  // without the caps
  const auto lines = mien::borders(mesh, normals);
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) EXPECT_EQ(line.points.rows(), 61);
}

TEST(SurfaceContour, NormalsOfASpherePointOutwards) {
  const mien::TriangleMesh mesh = sphere();
  const auto normals = mien::vertexNormals(mesh);
  for (int i = 60; i < mesh.vertices.rows() - 60; ++i)
    EXPECT_GT(normals.row(i).dot(mesh.vertices.row(i).normalized()), 0.999);
}

TEST(SurfaceContour, PiecesJoinWhateverTheirOrder) {
  const auto lines = mien::joinedPieces({{4, 3}, {1, 2}, {2, 3}, {7, 8}, {8, 9}, {9, 7}});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(lines[0] == std::vector<int>({4, 3, 2, 1}) || lines[0] == std::vector<int>({1, 2, 3, 4}));
  EXPECT_EQ(lines[1].size(), 4u);
  EXPECT_EQ(lines[1].front(), lines[1].back());
}

TEST(VectorSampling, EveryNthVertexIsStaggeredInAGrid) {
  VectorSampling sampling;
  ASSERT_EQ(sampling.parse("every:2"), "");
  const auto places = lattice(4, 1.0);
  EXPECT_EQ(sampling.choose(numbers(16), places, 4), (std::vector<int>{0, 2, 5, 7, 8, 10, 13, 15}));
  EXPECT_EQ(sampling.choose(numbers(16), places, 0).size(), 8u);
  sampling.step = 1;
  EXPECT_EQ(sampling.choose({3, 5, 9}, places, 4), (std::vector<int>{3, 5, 9}));
}

TEST(VectorSampling, EvenKeepsItsDistanceAndLeavesNoHoles) {
  VectorSampling sampling;
  ASSERT_EQ(sampling.parse("even:4mm"), "");
  const auto places = lattice(50, 0.9);
  const std::vector<int> chosen = sampling.choose(numbers(2500), places, 50);
  const double expected = std::pow(50 * 0.9, 2) / (16.0 * std::sqrt(0.75));  // of a hexagonal lattice
  EXPECT_NEAR(chosen.size() / expected, 1.0, 0.15);  // points along the border stand for less area
  for (size_t i = 0; i < chosen.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      EXPECT_GE((places.row(chosen[i]) - places.row(chosen[j])).norm(), 3.0 * (1.0 - 1e-5));
  for (int i = 0; i < 2500; ++i) {
    double nearest = 1e300;
    for (const int c : chosen) nearest = std::min(nearest, (places.row(i) - places.row(c)).norm());
    EXPECT_LT(nearest, 3.0);
  }
}

/// Two bumps between points of the lattice: each summit is drawn, and so is no low one beside them.
TEST(VectorSampling, EvenKeepsThePeaks) {
  VectorSampling sampling;
  ASSERT_EQ(sampling.parse("even:4mm"), "");
  const auto places = lattice(50, 0.9);
  Eigen::VectorXd lengths(2500);
  const auto bump = [&](int i, int summit, double height) {
    return height * std::exp(-(places.row(i) - places.row(summit)).squaredNorm());
  };
  const std::vector<int> before = sampling.choose(numbers(2500), places, 50);
  for (const int summit : {50 * 20 + 13, 50 * 21 + 14, 50 * 22 + 12, 50 * 33 + 17}) {
    const int other = 50 * 40 + 41, low = 50 * 5 + 44;
    for (int i = 0; i < 2500; ++i) lengths[i] = bump(i, summit, 10.0) + bump(i, other, 7.0) + bump(i, low, 1.0);
    const std::vector<int> chosen = sampling.choose(numbers(2500), places, 50, lengths);
    for (const int peak : {summit, other}) EXPECT_TRUE(std::count(chosen.begin(), chosen.end(), peak)) << peak;
    EXPECT_NEAR(static_cast<double>(chosen.size()) / before.size(), 1.0, 0.03);
    for (size_t i = 0; i < chosen.size(); ++i)
      for (size_t j = 0; j < i; ++j)
        EXPECT_GE((places.row(chosen[i]) - places.row(chosen[j])).norm(), 3.0 * (1.0 - 1e-5));
  }
}

TEST(VectorSampling, RefusesWhatItCannotRead) {
  VectorSampling sampling;
  for (const char* const text :
       {"", "every", "every:0", "every:1.5", "every:-2", "even:0", "even:x", "odd:2", "even:5cm", "even:1e9"})
    EXPECT_NE(sampling.parse(text), "") << text;
  EXPECT_EQ(sampling.text(), "every:1");
}

TEST(VectorScale, NumbersAreRound) {
  EXPECT_EQ(mien::roundAbove(3.0), 5.0);
  EXPECT_EQ(mien::roundAbove(5.0), 5.0);
  EXPECT_EQ(mien::roundAbove(0.11), 0.2);
  EXPECT_EQ(mien::roundBelow(3.0), 2.0);
  EXPECT_EQ(mien::roundBelow(9.9), 5.0);
  EXPECT_EQ(mien::roundBelow(10.0), 10.0);
  EXPECT_EQ(mien::roundBelow(0.019), 0.01);
  EXPECT_EQ(mien::automaticScale(8.0, 10.0), 0.8);
  EXPECT_EQ(mien::automaticScale(0.0, 10.0), 1.0);
  EXPECT_EQ(mien::automaticRangeEnd(7.68), 8.0);
  EXPECT_EQ(mien::automaticRangeEnd(8.68), 10.0);
  EXPECT_EQ(mien::automaticRangeEnd(0.0), 1.0);
  for (double longest = 1e-5; longest < 1e5; longest *= 1.37) {
    const double scale = mien::automaticScale(longest, 7.0);
    EXPECT_LE(longest / scale, 7.0 * (1.0 + 1e-8));
    EXPECT_GT(longest / scale, 7.0 / 1.5);
  }
}

TEST(VectorScale, TicksOfABarStandAtItsEndsAndDivideItEvenly) {
  using Ticks = std::vector<double>;
  EXPECT_EQ(mien::rangeTicks(0.0, 8.0, 5), (Ticks{0.0, 2.0, 4.0, 6.0, 8.0}));
  EXPECT_EQ(mien::rangeTicks(0.0, 6.0, 2), (Ticks{0.0, 3.0, 6.0}));
  EXPECT_EQ(mien::rangeTicks(-3.0, 3.0, 6), (Ticks{-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(mien::rangeTicks(0.0, 7.3, 4), (Ticks{0.0, 2.0, 4.0, 6.0, 7.3}));
  for (double largest = 1e-4; largest < 1e4; largest *= 1.37)
    for (const bool both : {false, true})
      for (const int most : {2, 3, 6, 11}) {
        const double end = mien::automaticRangeEnd(largest);
        const Ticks ticks = mien::rangeTicks(both ? -end : 0.0, end, most);
        ASSERT_GE(ticks.size(), 2u);
        EXPECT_LE(ticks.size(), most + 1u);
        EXPECT_NEAR(ticks.front(), both ? -end : 0.0, 1e-9 * end);
        EXPECT_NEAR(ticks.back(), end, 1e-9 * end);
        EXPECT_NE(std::count_if(ticks.begin(), ticks.end(), [&](double t) { return std::abs(t) < 1e-9 * end; }), 0);
        for (size_t i = 1; i < ticks.size(); ++i)
          EXPECT_NEAR(ticks[i] - ticks[i - 1], ticks[1] - ticks[0], 1e-9 * end) << end << " " << most;
      }
}

TEST(VectorRegion, ReadsPatchesNamesAndRectangles) {
  const mien::FaceCurves face = SyntheticFace::make();
  mien::VectorRegion region;
  EXPECT_TRUE(region.isWhole());
  EXPECT_EQ(region.parse("P7", nullptr), "");
  EXPECT_EQ(region.patch, 7);
  EXPECT_EQ(region.parse("-30,-80.5,30,-50", nullptr), "");
  EXPECT_EQ(region.rectangle->min().y(), -80.5);
  EXPECT_EQ(region.parse("mouth", &face), "");
  EXPECT_TRUE(region.box->contains(Eigen::Vector3d(face.curves.at(21, M_PI))));
  EXPECT_FALSE(region.box->contains(Eigen::Vector3d(face.curves.at(21, 0.0))));  // the same height at the back
  EXPECT_FALSE(region.box->contains(face.leftPupil));
  EXPECT_EQ(region.parse("eyes", &face), "");
  EXPECT_TRUE(region.box->contains(face.leftPupil));
  for (const char* const text : {"P9", "Px", "ears", "1,2,3", "3,0,1,2", "1,2,x,4", ""})
    EXPECT_NE(region.parse(text, &face), "") << text;
  EXPECT_NE(region.parse("brows", nullptr).find("rectangle"), std::string::npos);
  EXPECT_EQ(region.name, "eyes");
}

TEST(VectorPicture, ShowsTheFrontAndProjectsExactly) {
  const mien::MotionField field = sphereField({1.0, 2.0, 3.0});
  mien::VectorPictureOptions options;
  options.plane.look({1.0, 0.0, 1.0}, Eigen::Vector3d::UnitY());
  const mien::VectorPicture picture = mien::drawnVectors(field, options);
  EXPECT_NEAR(picture.arrows.size() / static_cast<double>(field.origins.rows()), 0.5, 0.03);
  for (const mien::PictureArrow& arrow : picture.arrows) {
    EXPECT_GT(field.origins.row(arrow.index).dot(options.plane.out), 0.0);
    EXPECT_NEAR(arrow.vector.x(), (1.0 - 3.0) / std::sqrt(2.0), 1e-14);
    EXPECT_EQ(arrow.vector.y(), 2.0);
    EXPECT_NEAR(arrow.towards, 4.0 / std::sqrt(2.0), 1e-14);
    EXPECT_NEAR(arrow.magnitude, std::sqrt(14.0), 1e-14);
  }
  options.hidden = true;
  EXPECT_EQ(mien::drawnVectors(field, options).arrows.size(), static_cast<size_t>(field.origins.rows()));
  ASSERT_EQ(picture.outline.size(), 3u);  // and the poles, points where the mesh is open
  EXPECT_NEAR(picture.frame.sizes().x(), 100.0, 0.5);
}

/// A sheet of 40 x 80 mm, 50 mm in front of one that reaches `beyond` its right edge.
mien::MotionField sheetsField(double beyond) {
  mien::MotionField field;
  const auto addSheet = [&](double right, double top, double depth) {
    const int across = static_cast<int>(std::lround(right + 40.0)), up = static_cast<int>(std::lround(2.0 * top));
    mien::TriangleMesh& mesh = field.surface;
    const int first = static_cast<int>(mesh.vertices.rows()), cells = static_cast<int>(mesh.triangles.rows());
    mesh.vertices.conservativeResize(first + (across + 1) * (up + 1), 3);
    mesh.triangles.conservativeResize(cells + 2 * across * up, 3);
    for (int y = 0, t = cells; y <= up; ++y)
      for (int x = 0; x <= across; ++x) {
        const int at = first + y * (across + 1) + x;
        mesh.vertices.row(at) << x - 40.0, y - top, depth;
        if (x == across || y == up) continue;
        mesh.triangles.row(t++) << at, at + 1, at + across + 1;
        mesh.triangles.row(t++) << at + 1, at + across + 2, at + across + 1;
      }
  };
  addSheet(0.0, 40.0, 50.0);
  addSheet(beyond, 30.0, 0.0);
  field.surfaceNormals = mien::vertexNormals(field.surface);
  return field;
}

TEST(VectorPicture, ASliverBehindTheOutlineIsLeftOut) {
  for (const double beyond : {2.0, 5.0, 7.0, 10.0, 20.0}) {
    const mien::VectorPicture picture = mien::drawnVectors(sheetsField(beyond), {});
    double right = -1e9, length = 0.0;
    for (const auto& line : picture.outline) {
      right = std::max(right, line.col(0).maxCoeff());
      for (int i = 1; i < line.rows(); ++i) length += (line.row(i) - line.row(i - 1)).norm();
    }
    const bool isSliver = beyond < 8.0;
    EXPECT_EQ(right, isSliver ? 0.0 : beyond);
    EXPECT_NEAR(length, isSliver ? 240.0 : 240.0 + 60.0 + 2.0 * beyond, 4.0) << beyond;
  }
}

TEST(VectorPicture, ZeroMotionHasNoArrows) {
  const mien::VectorPicture picture = mien::drawnVectors(sphereField({0.0, 0.0, 0.0}), {});
  EXPECT_TRUE(picture.arrows.empty());
  EXPECT_GT(picture.still, 1000);
  EXPECT_EQ(picture.largest(), 0.0);
  EXPECT_EQ(picture.longest(), 0.0);
}

TEST(VectorPicture, WithoutLinesTheArrowsAreTheSame) {
  const mien::MotionField field = sphereField({1.0, 2.0, 0.0});
  mien::VectorPictureOptions options;
  options.sampling.kind = VectorSampling::Kind::Even;
  options.sampling.spacing = 10.0;
  const mien::VectorPicture whole = mien::drawnVectors(field, options);
  options.lines = false;
  const mien::VectorPicture bare = mien::drawnVectors(field, options);
  EXPECT_FALSE(whole.outline.empty());
  EXPECT_TRUE(bare.outline.empty());
  ASSERT_GT(whole.arrows.size(), 20u);
  EXPECT_EQ(bare.chosen, whole.chosen);
}

TEST(VectorPicture, ARegionIsEnlargedOrShownWithinTheWhole) {
  const mien::MotionField field = sphereField({0.0, 1.0, 0.0});
  mien::VectorPictureOptions options;
  options.region.parse("-10,-5,20,15", nullptr);
  const mien::VectorPicture part = mien::drawnVectors(field, options);
  EXPECT_GT(part.arrows.size(), 10u);
  for (const mien::PictureArrow& arrow : part.arrows) {
    EXPECT_TRUE(arrow.tail.x() >= -10.0 && arrow.tail.x() <= 20.0);
    EXPECT_TRUE(arrow.tail.y() >= -5.0 && arrow.tail.y() <= 15.0);
  }
  EXPECT_EQ(part.frame.sizes().x(), 30.0);
  options.wholeFrame = true;
  EXPECT_GT(mien::drawnVectors(field, options).frame.sizes().x(), 99.0);
}

TEST(VectorPicture, AnEmptyFieldIsNoFault) {
  EXPECT_TRUE(mien::drawnVectors(mien::MotionField(), {}).arrows.empty());
}

TEST(VectorPicture, AutomaticSamplingSuitsThePrintedSize) {
  const mien::MotionField field = sphereField({0.0, 1.0, 0.0});
  mien::VectorPictureOptions options;
  options.sampling.parse("auto");
  for (const double width : {40.0, 80.0, 160.0}) {
    options.paper = {width, width};
    const mien::VectorPicture picture = mien::drawnVectors(field, options);
    EXPECT_EQ(picture.sampling.kind, VectorSampling::Kind::Even);
    const double printed = picture.sampling.spacing * width / picture.frame.sizes().x();
    EXPECT_GE(printed, mien::printedSpacing * (1.0 - 1e-9)) << width;
    EXPECT_LT(printed, 1.5 * mien::printedSpacing) << width;
  }
}

TEST(MotionTable, WritesRoundingAsZeroAndTheRestToTheBit) {
  mien::MotionField field;
  field.origins = mien::MotionField::Points::Constant(2, 3, 1.5);
  field.vectors.resize(2, 3);
  field.vectors << -1.09e-13, 0.5, 1e-10, 2e-9, 0.0, 0.0;
  EXPECT_EQ(mien::motionTableText(field, {0, 1}),
            "u,v,x,y,z,dx,dy,dz,magnitude_mm\n,,1.5,1.5,1.5,0,0.5,0,0.5\n,,1.5,1.5,1.5,2e-09,0,0,2e-09\n");
  const std::vector<int> first = {0};
  EXPECT_EQ(mien::motionTableText({{"7", &field, &first}}),
            "frame,u,v,x,y,z,dx,dy,dz,magnitude_mm\n7,,,1.5,1.5,1.5,0,0.5,0,0.5\n");
}
