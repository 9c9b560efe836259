#include <gtest/gtest.h>

#include "CurveTransform.h"
#include "HarmonicSplit.h"

using namespace mien;

namespace {

Eigen::MatrixXd randomValues(int curves, int k) {
  std::srand(7);
  return 100.0 * Eigen::MatrixXd::Random(curves, k);
}

}  // namespace

TEST(CurveTransform, KeepsLengthsAndComesBack) {
  for (const auto& [curves, k] : {std::pair{28, 40}, {1, 8}, {28, 34}, {28, 512}, {28, 4096}}) {
    const Eigen::MatrixXd values = randomValues(curves, k);
    const CurveTransform transform(curves, k);
    const Eigen::MatrixXd coefficients = transform.forward(values);
    EXPECT_NEAR(coefficients.norm() / values.norm(), 1.0, 1e-13) << k;
    EXPECT_LT((transform.inverse(coefficients) - values).cwiseAbs().maxCoeff(), 1e-11) << k;
  }
}

TEST(CurveTransform, AroundACurveItIsTheFourierAnalysisOfTheFace) {
  const Eigen::MatrixXd values = randomValues(1, 40);
  const Eigen::VectorXd expected = HarmonicSplit(40, 20, false).analysis() * values.transpose();
  const Eigen::VectorXd found = CurveTransform(1, 40).forward(values).transpose();
  for (int i = 0; i < 40; ++i)
    EXPECT_NEAR(found[i], expected[i] * std::sqrt(i == 0 || i == 39 ? 40.0 : 20.0), 1e-10) << i;
}

TEST(CurveTransform, AlongTheCurvesACosineIsOneCoefficient) {
  Eigen::MatrixXd values(28, 8);
  for (int i = 0; i < 28; ++i) values.row(i).setConstant(std::cos(M_PI * (i + 0.5) * 3 / 28));
  Eigen::MatrixXd coefficients = CurveTransform(28, 8).forward(values);
  EXPECT_NEAR(coefficients(3, 0), std::sqrt(14.0 * 8.0), 1e-12);
  coefficients(3, 0) = 0.0;
  EXPECT_LT(coefficients.cwiseAbs().maxCoeff(), 1e-12);
}
