#include "FaceSeams.h"

#include "RandomCurves.h"

#include <gtest/gtest.h>

using namespace mien;

namespace {

FaceSeams seamsOf(const std::string& scheme, int modes, const FaceCurves& face, int columns = FaceSeams::defaultColumns) {
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
