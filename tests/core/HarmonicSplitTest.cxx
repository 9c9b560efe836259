#include <gtest/gtest.h>

#include <cmath>

#include "ClosedCurves.h"
#include "HarmonicSplit.h"

using namespace mien;

TEST(HarmonicSplit, AnalysisAndSynthesisAreInverse) {
  for (const int k : {8, 10, 40, 64}) {
    const HarmonicSplit split(k, 3, true);
    const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(k, 0.0, 2.0 * M_PI * (k - 1) / k);
    EXPECT_LE((split.synthesis(v, 0) * split.analysis() - Eigen::MatrixXd::Identity(k, k)).cwiseAbs().maxCoeff(),
              1e-13);
  }
}

TEST(HarmonicSplit, PartsHoldEveryCoefficientOnce) {
  for (int modes = 0; modes <= 20; ++modes) {
    const HarmonicSplit split(40, modes, true);
    int next = 0;
    for (int part = 0; part < split.count(); ++part) {
      if (split.coefficientCount(part) > 0) {
        EXPECT_EQ(split.firstCoefficient(part), next);
      }
      next += split.coefficientCount(part);
    }
    EXPECT_EQ(next, 40);
    EXPECT_EQ(split.coefficientCount(split.count() - 1) == 0, modes == 20);
  }
}

TEST(HarmonicSplit, InterpolantIsThatOfTheCardinalFunctions) {
  const HarmonicSplit split(12, 2, true);
  const Eigen::VectorXd samples = Eigen::VectorXd::Random(12);
  Eigen::VectorXd v(1);
  for (double x = -1.0; x < 8.0; x += 0.13) {
    v[0] = x;
    EXPECT_NEAR((split.synthesis(v, 0) * split.analysis() * samples)[0], cardinalWeights(12, x).dot(samples), 1e-13);
  }
}

TEST(HarmonicSplit, DerivativesOfAMode) {
  const HarmonicSplit split(16, 5, true);
  const Eigen::VectorXd v = Eigen::VectorXd::Constant(1, 0.7);
  EXPECT_NEAR(split.synthesis(v, 1)(0, 5), -3 * std::sin(2.1), 1e-14);
  EXPECT_NEAR(split.synthesis(v, 1)(0, 6), 3 * std::cos(2.1), 1e-14);
  EXPECT_NEAR(split.synthesis(v, 2)(0, 5), -9 * std::cos(2.1), 1e-13);
  EXPECT_EQ(split.synthesis(v, 1)(0, 0), 0.0);
}
