#include <gtest/gtest.h>

#include "BoxRatio.h"
#include "CurveMiss.h"
#include "FaceArea.h"
#include "FaceLebesgue.h"
#include "FoldedCells.h"
#include "LargestSeamAngle.h"
#include "ModeOperator.h"
#include "RandomCurves.h"
#include "SchemeOptions.h"
#include "SurfaceDeparture.h"
#include "WillmoreEnergy.h"

using namespace mien;

namespace {

/// A surface of revolution about y: radius and height, each with two derivatives, as functions of t; the whole face is
/// t = 0 .. 1.
struct Profile {
  Eigen::Vector3d radius, height;
};

template <class Function>
FaceSample revolution(const Function& profile, int rows, int columns) {
  return FaceSample(
      [profile](int patch, double u, double v) {
        const Profile p = profile((patch + u) / 9.0);
        const Eigen::Vector3d out(-std::sin(v), 0, -std::cos(v)), along(-std::cos(v), 0, std::sin(v)), up(0, 1, 0);
        SurfaceJet jet;
        jet.s = p.radius[0] * out + p.height[0] * up;
        jet.su = (p.radius[1] * out + p.height[1] * up) / 9.0;
        jet.suu = (p.radius[2] * out + p.height[2] * up) / 81.0;
        jet.sv = p.radius[0] * along;
        jet.suv = p.radius[1] * along / 9.0;
        jet.svv = -p.radius[0] * out;
        return jet;
      },
      rows, columns);
}

/// Between the polar angles 0.2 and 2.5.
Profile sphereProfile(double radius, double t) {
  const double w = 2.3, s = 0.2 + w * t;
  return {{radius * std::sin(s), radius * w * std::cos(s), -radius * w * w * std::sin(s)},
          {radius * std::cos(s), -radius * w * std::sin(s), -radius * w * w * std::cos(s)}};
}

Profile torusProfile(double large, double small, double t) {
  const double w = 2.0 * M_PI, s = w * t;
  return {{large + small * std::cos(s), -small * w * std::sin(s), -small * w * w * std::cos(s)},
          {small * std::sin(s), small * w * std::cos(s), -small * w * w * std::sin(s)}};
}

Profile cylinderProfile(double radius, double height, double t) {
  return {{radius, 0, 0}, {-height * t, -height, 0}};
}

/// A measure's error shrinks by 4 when rows are doubled, to below the tolerance.
template <class Function>
void expectConvergence(const Function& measure, double exact, double tolerance) {
  double error = 0.0;
  for (const int rows : {29, 56, 110, 218}) {
    const double now = std::abs(measure(rows) - exact);
    if (error > tolerance) {
      EXPECT_GT(error / std::max(now, 1e-300), 3.5) << rows;
    }
    error = now;
  }
  EXPECT_LT(error, tolerance);
}

}  // namespace

TEST(FaceArea, ConvergesToSphereAndTorusAndIsExactOnACylinder) {
  const auto sphere = [](double t) { return sphereProfile(80.0, t); };
  const auto torus = [](double t) { return torusProfile(80.0, 20.0, t); };
  const auto cylinder = [](double t) { return cylinderProfile(80.0, 200.0, t); };
  expectConvergence([&](int rows) { return faceArea(revolution(sphere, rows, 40)); },
                    2.0 * M_PI * 80.0 * 80.0 * (std::cos(0.2) - std::cos(2.5)), 2.0);
  EXPECT_NEAR(faceArea(revolution(torus, 56, 40)), 4.0 * M_PI * M_PI * 80.0 * 20.0, 1e-6);  // periodic in u as well
  EXPECT_NEAR(faceArea(revolution(cylinder, 29, 40)), 2.0 * M_PI * 80.0 * 200.0, 1e-7);
}

TEST(WillmoreEnergy, ConvergesToTheKnownEnergies) {
  const auto sphere = [](double t) { return sphereProfile(80.0, t); };
  const auto torus = [](double t) { return torusProfile(std::sqrt(2.0) * 30.0, 30.0, t); };
  const auto cylinder = [](double t) { return cylinderProfile(80.0, 200.0, t); };
  expectConvergence([&](int rows) { return willmoreEnergy(revolution(sphere, rows, 40)); },
                    2.0 * M_PI * (std::cos(0.2) - std::cos(2.5)), 3e-4);
  EXPECT_NEAR(willmoreEnergy(revolution(torus, 110, 40)), 2.0 * M_PI * M_PI, 1e-9);  // Willmore's torus
  EXPECT_NEAR(willmoreEnergy(revolution(cylinder, 29, 40)), M_PI * 200.0 / (2.0 * 80.0), 1e-10);
}

TEST(SurfaceDeparture, OfConcentricCylindersIsTheDifferenceOfTheirRadii) {
  const auto wide = revolution([](double t) { return cylinderProfile(83.0, 200.0, t); }, 40, 30);
  const auto narrow = revolution([](double t) { return cylinderProfile(80.0, 200.0, t); }, 40, 30);
  const SurfaceDeparture departure(wide, narrow);
  EXPECT_NEAR(departure.rms, 3.0, 1e-12);
  EXPECT_NEAR(departure.maximum, 3.0, 1e-12);
  EXPECT_EQ(SurfaceDeparture(wide, wide).maximum, 0.0);
}

TEST(FoldedCells, AreFoundWhereASurfaceTurnsBack) {
  // The height runs back between t = 0.5 and 0.5 + 1 / 27: two creases inside patch 4.
  const auto folded = [](double t) {
    const double back = std::clamp(t - 0.5, 0.0, 1.0 / 27.0);
    return Profile{{80.0, 0, 0}, {-200.0 * (t - 2.0 * back), 0, 0}};
  };
  const FoldedCells cells(revolution(folded, 56, 40), -1e9);
  ASSERT_EQ(cells.count(), 4 * 40);  // a cell on each side of each crease
  EXPECT_EQ(cells.countOnSeams(), 0);
  for (const FoldedCells::Cell& cell : cells.cells()) EXPECT_EQ(cell.patch, 4);
  EXPECT_EQ(FoldedCells(revolution([](double t) { return cylinderProfile(80.0, 200.0, t); }, 56, 40), -1e9).count(), 0);
}

TEST(FoldedCells, OnASeamAreToldApartAndTheOpenMouthIsNoSeam) {
  // Patch 7 runs back up over patch 6: a crease at the mouth, and another at the next seam.
  const auto surface = [](int patch, double u, double v) {
    SurfaceJet jet;
    const double t = patch < 7 ? patch + u : patch == 7 ? 7.0 - u : 6.0 + (patch - 8) + u;
    jet.s << -80.0 * std::sin(v), -20.0 * t, -80.0 * std::cos(v);
    return jet;
  };
  const FoldedCells whole(FaceSample(surface, 56, 40), -1e9);
  EXPECT_EQ(whole.count(), 4 * 40);
  EXPECT_EQ(whole.countOnSeams(), 4 * 40);
  MouthCorners mouth;
  mouth.begin = M_PI - 0.6;
  mouth.end = M_PI + 0.6;
  const FoldedCells open(FaceSample(surface, 56, 40, mouth), -1e9);
  EXPECT_EQ(open.count(), 4 * 40 - 2 * 8);
  const FoldedCells frontal(FaceSample(surface, 56, 40), 50.0);
  EXPECT_GT(frontal.count(), 0);
  for (const FoldedCells::Cell& cell : frontal.cells()) EXPECT_GT(cell.middle.z(), 50.0);
}

TEST(FoldedCells, CellsWithoutAreaAreNoFolds) {
  const auto surface = [](int patch, double u, double v) {
    SurfaceJet jet;
    const double noise = 1e-9 * std::sin(1000.0 * (u + v));
    jet.s << -80.0 * std::sin(v), patch == 3 ? -60.0 + noise : -20.0 * (patch > 3 ? patch - 1 + u : patch + u),
        -80.0 * std::cos(v);
    return jet;
  };
  EXPECT_EQ(FoldedCells(FaceSample(surface, 110, 40), -1e9).count(), 0);
}

TEST(LargestSeamAngle, IsThatOfAConeOnACylinder) {
  const auto surface = [](int patch, double u, double v) {
    const double slope = patch < 5 ? 0.0 : std::tan(M_PI / 6.0);
    const double t = patch + u, radius = 80.0 - 10.0 * slope * std::max(0.0, t - 5.0);
    SurfaceJet jet;
    jet.s << -radius * std::sin(v), -10.0 * t, -radius * std::cos(v);
    jet.su << 10.0 * slope * std::sin(v), -10.0, 10.0 * slope * std::cos(v);
    jet.sv << -radius * std::cos(v), 0.0, radius * std::sin(v);
    return jet;
  };
  EXPECT_NEAR(largestSeamAngle(FaceSample(surface, 29, 40)), 30.0, 1e-9);
}

TEST(LargestSeamAngle, VanishesInSmoothSchemesAndNotInFourCurve) {
  const FaceCurves face = randomFace();
  for (const char* scheme : {"tangent", "curvature", "spline"})
    EXPECT_LT(largestSeamAngle(FaceSample(face, optionsFor(scheme, 1.0), 56, 80)), 1e-6) << scheme;
  EXPECT_GT(largestSeamAngle(FaceSample(face, optionsFor("four-curve", 1.0), 56, 80)), 10.0);
}

TEST(CurveMiss, IsRoundingWhereASchemePassesItsCurves) {
  const FaceCurves face = randomFace();
  for (const char* scheme : {"four-curve", "tangent", "curvature", "spline"})
    EXPECT_LT(curveMiss(face, optionsFor(scheme, 1.0)), 1e-10 * sizeOf(face.curves)) << scheme;
  EXPECT_GT(curveMiss(face, optionsFor("derivative", 1.0)), 0.1);
  FaceSurfaceOptions cut = optionsFor("spline", 1.0);
  cut.remainder = false;
  EXPECT_GT(curveMiss(face, cut), 0.1);
}

TEST(BoxRatio, GrowsWithWhatLeavesTheCurves) {
  const FaceCurves face = randomFace();
  const double spline = boxRatio(FaceSample(face, optionsFor("spline", 1.0), 56, 40), face.curves);
  EXPECT_GT(spline, 0.99);
  EXPECT_LT(spline, 1.1);
  EXPECT_GT(boxRatio(FaceSample(face, optionsFor("four-curve", 10.0), 56, 40), face.curves), 100.0);
}

TEST(FaceLebesgue, OfFourCurvesIsThatOfTheLargestRate) {
  for (const double a : {0.5, 1.0, 5.0}) {
    const double rate = a * 6.0;
    const ModeOperator mode(rate, {{0, 0, 0}, {1.0 / 3.0, 0, 1}, {2.0 / 3.0, 0, 2}, {1, 0, 3}});
    EXPECT_NEAR(faceLebesgueConstant(optionsFor("four-curve", a), HarmonicSplit(40, 5, true)), mode.lebesgueConstant(),
                1e-12 * mode.lebesgueConstant());
  }
}

TEST(FaceLebesgue, OfTheSplineStaysBounded) {
  for (const double a : {0.01, 0.1, 1.0, 3.0, 10.0, 100.0, 1000.0})
    for (const int modes : {0, 5, 20}) {
      FaceSurfaceOptions options = optionsFor("spline", a);
      options.modes = modes;
      const double constant = faceLebesgueConstant(options, HarmonicSplit(40, modes, true));
      EXPECT_LE(constant, 1.56) << a << " " << modes;
      EXPECT_GE(constant, 1.0 - 1e-12);
    }
}

TEST(ModeOperator, LebesgueConstantIsTheLargestOfManySamples) {
  const auto lists = {faceSchemes()[0].pieces[0].conditions, faceSchemes()[1].pieces[0].conditions,
                      faceSchemes()[2].pieces[0].conditions, faceSchemes()[3].pieces[0].conditions,
                      faceSchemes()[4].pieces[0].conditions};
  for (const auto& conditions : lists)
    for (const double rate : {0.0, 0.3, 2.0, 6.0, 17.0, 60.0, 200.0}) {
      const ModeOperator mode(rate, conditions);
      double largest = 0.0;
      for (int i = 0; i <= 20000; ++i) {
        const Eigen::RowVectorXd row = mode.row(i / 20000.0);
        double sum = 0.0;
        for (size_t j = 0; j < conditions.size(); ++j) sum += conditions[j].derivative == 0 ? std::abs(row[j]) : 0.0;
        largest = std::max(largest, sum);
      }
      EXPECT_NEAR(mode.lebesgueConstant() / largest, 1.0, 2e-6 * (1.0 + rate * rate * 1e-2))
          << rate << " " << conditions.size();
      EXPECT_GE(mode.lebesgueConstant(), largest * (1.0 - 1e-12));
    }
}
