#include <gtest/gtest.h>

#include "FaceSeams.h"
#include "PDESurface.h"
#include "RandomCurves.h"

using namespace mien;

namespace {

FaceSeams seamsOf(const std::string& scheme, int modes, const FaceCurves& face,
                  int columns = FaceSeams::defaultColumns) {
  FaceSurfaceOptions options;
  options.scheme = scheme;
  options.modes = modes;
  FaceSeams seams(options, face.curves.pointsPerCurve, columns);
  EXPECT_EQ(seams.fault(), "");
  seams.setCurves(face.curves);
  return seams;
}

}  // namespace

TEST(FaceSeams, AreNamedAfterTheirPatches) {
  EXPECT_EQ(FaceSeams::name(0), "P0|P1");
  EXPECT_EQ(FaceSeams::name(7), "P7|P8");
}

// The lips coincide in these curves: P6|P7 is the seam of a closed mouth.
TEST(FaceSeams, OfSmoothSchemesHaveNoAngleAtAnySampleOfRandomFaces) {
  for (const std::string scheme : {"tangent", "curvature", "spline"})
    for (const unsigned seed : {1u, 2u, 3u})
      for (const int modes : {0, 5, 20}) {
        const FaceSeams seams = seamsOf(scheme, modes, randomFace(40, seed));
        for (int seam = 0; seam < FaceSeams::seamCount; ++seam) {
          EXPECT_EQ(seams.whole(seam).count(), 400);
          EXPECT_LE(seams.whole(seam).max().g0, 1e-10) << scheme << FaceSeams::name(seam) << " N " << modes;
          EXPECT_LE(seams.whole(seam).max().g1, 1e-6) << scheme << FaceSeams::name(seam) << " N " << modes;
          EXPECT_LE(seams.whole(seam).max().c1, 1e-9) << scheme << FaceSeams::name(seam) << " N " << modes;
          if (scheme == "tangent") continue;
          EXPECT_LE(seams.whole(seam).max().c2, 1e-7) << scheme << FaceSeams::name(seam) << " N " << modes;
          EXPECT_LE(seams.whole(seam).max().g2, 1e-7) << scheme << FaceSeams::name(seam) << " N " << modes;
        }
      }
}

TEST(FaceSeams, AreAsSmoothAsTheSchemeSaysAndNoSmoother) {
  const FaceCurves face = randomFace();
  for (int seam = 0; seam < FaceSeams::seamCount; ++seam) {
    EXPECT_GE(seamsOf("four-curve", 5, face).whole(seam).mean().g1, 1.0);
    EXPECT_LE(seamsOf("derivative", 5, face).whole(seam).max().g1, 1e-6);
    EXPECT_GE(seamsOf("derivative", 5, face).whole(seam).mean().g2, 1e-4);
    EXPECT_GE(seamsOf("tangent", 5, face).whole(seam).mean().c2, 1e-2);
    EXPECT_LE(seamsOf("sixth-order", 5, face).whole(seam).max().c2, 1e-7);
  }
}

// At the samples both lips are curves of the surface, so the gap is known.
TEST(FaceSeams, MeasureTheGapOfAnOpenMouthAndNoOther) {
  FaceCurves face = randomFace();
  face.curves.curve(FaceLayout::lowerLip).row(20).y() -= 12.0;
  const FaceSeams seams = seamsOf("spline", 5, face, 40);
  EXPECT_NEAR(seams.measures(6, 20).g0, 12.0, 1e-10);
  EXPECT_NEAR(seams.measures(6, 3).g0, 0.0, 1e-10);
  for (const int seam : {0, 1, 2, 3, 4, 5, 7}) EXPECT_LE(seams.whole(seam).max().g0, 1e-10);
}

TEST(FaceSeams, FrontalPartIsThatInFront) {
  const FaceSeams seams = seamsOf("four-curve", 5, randomFace());
  for (int seam = 0; seam < FaceSeams::seamCount; ++seam) {
    int count = 0;
    double largest = 0.0;
    for (int i = 0; i < seams.columnCount(); ++i) {
      if (!(seams.position(seam, i).z() > 50.0)) continue;
      ++count;
      largest = std::max(largest, seams.measures(seam, i).g1);
    }
    EXPECT_EQ(seams.frontal(seam).count(), count);
    EXPECT_GT(count, 50);
    EXPECT_LT(count, 200);
    EXPECT_EQ(seams.frontal(seam).max().g1, largest);
    EXPECT_LE(largest, seams.whole(seam).max().g1);
  }
}

TEST(FaceSeams, KeptOperatorsGiveWhatNewOnesGive) {
  FaceSeams kept = seamsOf("tangent", 5, randomFace(40, 1));
  kept.setCurves(randomFace(40, 2).curves);
  const FaceSeams fresh = seamsOf("tangent", 5, randomFace(40, 2));
  for (int i = 0; i < 400; ++i) EXPECT_EQ(kept.measures(4, i).c2, fresh.measures(4, i).c2);
  EXPECT_EQ(kept.frontal(3).count(), fresh.frontal(3).count());
}

namespace {

/// S or a derivative of it at the seams, both sides of each, evaluated as a grid.
RowMajor<double> gridOfSides(const FaceSurfaceOptions& options, const FaceCurves& face, int orderU, int orderV) {
  const std::vector<SurfacePiece> pieces = facePieces(options, RowLayout(29, false));
  const size_t perPatch = pieces.size() / FaceLayout::patchCount;
  std::vector<SurfacePiece> sides;
  for (size_t patch = 0; patch < FaceLayout::patchCount; ++patch)
    for (const bool first : {true, false}) {
      sides.push_back(pieces[first ? patch * perPatch : (patch + 1) * perPatch - 1]);
      sides.back().u = {first ? 0.0 : 1.0};
      sides.back().firstRow = static_cast<int>(sides.size()) - 1;
    }
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(100, 0.0, 2.0 * M_PI * 99 / 100);
  PDESurface<double> surface(sides, HarmonicSplit(40, options.modes, options.remainder), FaceLayout::curveCount, v, 2);
  surface.setCurves(face.curves);
  RowMajor<double> grid(18, 300);
  surface.evaluate(orderU, orderV, 0, {grid.data(), grid.rows(), grid.cols()});
  return grid;
}

}  // namespace

TEST(FaceSeams, JetsAreThoseOfTheSurfaceOnEitherSide) {
  const FaceCurves face = randomFace();
  constexpr std::array<std::array<int, 2>, 6> orders = {{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  constexpr Eigen::Vector3d SurfaceJet::*members[] = {&SurfaceJet::s,   &SurfaceJet::su,  &SurfaceJet::sv,
                                                      &SurfaceJet::suu, &SurfaceJet::suv, &SurfaceJet::svv};
  for (const std::string scheme : {"four-curve", "spline"}) {
    FaceSurfaceOptions options;
    options.scheme = scheme;
    options.smoothing = {1, 2, 1, 0.5, 1, 1, 3, 1, 1};
    FaceSeams seams(options, 40, 100);
    seams.setCurves(face.curves);
    for (size_t i = 0; i < orders.size(); ++i) {
      const RowMajor<double> grid = gridOfSides(options, face, orders[i][0], orders[i][1]);
      for (int seam = 0; seam < FaceSeams::seamCount; ++seam)
        for (int side = 0; side < 2; ++side)
          for (int column = 0; column < 100; ++column)
            EXPECT_LE((seams.jet(seam, side, column).*members[i] -
                       grid.block<1, 3>(2 * seam + 1 + side, 3 * column).transpose())
                          .norm(),
                      1e-12 * grid.cwiseAbs().maxCoeff())
                << scheme << " " << FaceSeams::name(seam);
    }
  }
}
