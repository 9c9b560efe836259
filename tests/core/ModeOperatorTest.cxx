#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "CsvRows.h"
#include "FaceScheme.h"
#include "ModeOperator.h"

using namespace mien;

namespace {

constexpr double third = 1.0 / 3.0;

std::vector<Condition> values() {
  return {{0.0, 0, 0}, {third, 0, 1}, {2.0 / 3.0, 0, 2}, {1.0, 0, 3}};
}

std::vector<Condition> ends(const std::vector<int>& derivatives) {
  std::vector<Condition> conditions;
  for (const double u : {0.0, 1.0})
    for (const int d : derivatives) conditions.push_back({u, d, 0});
  return conditions;
}

std::vector<Condition> both(std::vector<Condition> a, const std::vector<Condition>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::map<std::string, std::vector<Condition>> conditionLists() {
  return {{"four-curve", values()},
          {"derivative", ends({0, 1})},
          {"sixth-order", ends({0, 1, 2})},
          {"tangent", both(values(), ends({1}))},
          {"curvature", both(values(), ends({1, 2}))}};
}

double largestAbsolute(const std::vector<std::string>& row) {
  double largest = 0.0;
  for (size_t i = 4; i < row.size(); ++i) largest = std::max(largest, std::abs(std::stod(row[i])));
  return largest;
}

}  // namespace

// 120-digit arithmetic, tests/core/reference/mode_operator.py. Values to 1e-12 (1 + Lebesgue constant) absolute;
// derivatives are larger by up to rate^d, so they are compared relative to their own largest coefficient as well.
TEST(ModeOperator, AgreesWithMultiprecisionReference) {
  const auto lists = conditionLists();
  const auto rows = csvRows(std::string(MIEN_TEST_DIR) + "/core/reference/mode_operator.csv");
  ASSERT_GT(rows.size(), 1000u);
  for (const auto& row : rows) {
    const ModeOperator mode(std::stod(row[1]), lists.at(row[0]));
    ASSERT_TRUE(mode.solvable());
    const int derivative = std::stoi(row[3]);
    const Eigen::RowVectorXd u = mode.row(std::stod(row[2]), derivative);
    const double scale = 1.0 + mode.lebesgueConstant() + (derivative ? largestAbsolute(row) : 0.0);
    for (int i = 0; i < u.size(); ++i)
      EXPECT_NEAR(u[i], std::stod(row[4 + i]), 1e-12 * scale)
          << row[0] << " rate " << row[1] << " u " << row[2] << " derivative " << derivative << " condition " << i;
  }
}

TEST(ModeOperator, MeetsItsConditionsAtEveryRate) {
  for (const auto& [name, conditions] : conditionLists())
    for (const double rate : {0.0, 1e-6, 1e-3, 0.1, 1.0, 4.999, 5.0, 5.001, 7.0, 12.0, 30.0, 60.0}) {
      const ModeOperator mode(rate, conditions);
      const double scale = 1.0 + mode.lebesgueConstant();
      for (size_t i = 0; i < conditions.size(); ++i) {
        const double unit = std::pow(1.0 + rate, conditions[i].derivative);
        const Eigen::RowVectorXd u = mode.row(conditions[i].u, conditions[i].derivative);
        for (size_t j = 0; j < conditions.size(); ++j)
          EXPECT_NEAR(u[j], i == j ? 1.0 : 0.0, 1e-12 * scale * unit) << name << " rate " << rate;
      }
    }
}

// The solution space contains u^k e^(+-ru), so data taken from one of them give it back everywhere.
TEST(ModeOperator, GivesExactSolutionsBack) {
  for (const auto& [name, conditions] : conditionLists())
    for (const double rate : {1e-3, 0.5, 3.0, 5.5, 15.0, 40.0}) {
      const ModeOperator mode(rate, conditions);
      const auto exact = [rate](double u, int d) {
        return std::pow(-rate, d) * std::exp(-rate * u) + std::pow(rate, d) * std::exp(-rate * (1 - u));
      };
      Eigen::VectorXd data(conditions.size());
      for (size_t i = 0; i < conditions.size(); ++i) data[i] = exact(conditions[i].u, conditions[i].derivative);
      const double tolerance = 1e-12 * (1.0 + mode.lebesgueConstant());
      for (double u = 0.0; u <= 1.0; u += 0.01)
        EXPECT_NEAR(mode.row(u).dot(data), exact(u, 0), tolerance) << name << " rate " << rate;
    }
}

TEST(ModeOperator, EndConditionsHoldAtVeryLargeRates) {
  for (const double rate : {1000.0, 6000.0, 21000.0})
    for (const auto& conditions : {ends({0, 1}), ends({0, 1, 2})}) {
      const ModeOperator mode(rate, conditions);
      ASSERT_TRUE(mode.solvable());
      EXPECT_LE(mode.lebesgueConstant(), 1.0 + 1e-9);
      for (const Condition& c : conditions) EXPECT_NEAR(mode.row(c.u, 0)[0], c.u == 0.0 ? 1.0 : 0.0, 1e-12);
      // Near u = 0 the solution for data (1, 0) at u = 0 is (1 + r u) e^(-r u) at order 4.
      if (conditions.size() == 4) {
        EXPECT_NEAR(mode.row(0.5 / rate)[0], 1.5 * std::exp(-0.5), 1e-12);
      }
    }
}

TEST(ModeOperator, LebesgueConstantsOfFourCurvesAreThePublishedOnes) {
  const std::map<double, double> expected = {{1, 1.63},  {5, 1.83},   {6, 1.99},    {10, 3.61},
                                             {20, 43.8}, {40, 1.7e4}, {100, 3.3e12}};
  for (const auto& [rate, constant] : expected)
    EXPECT_NEAR(ModeOperator(rate, values()).lebesgueConstant() / constant, 1.0, rate < 30 ? 0.003 : 0.03) << rate;
}

TEST(ModeOperator, RefusesConditionsThatDetermineNothing) {
  EXPECT_FALSE(ModeOperator(0.0, {{0.0, 0, 0}, {0.0, 0, 1}, {1.0, 0, 2}, {1.0, 1, 3}}).solvable());
  EXPECT_FALSE(ModeOperator(2.0, {{0.0, 0, 0}, {0.0, 0, 1}, {1.0, 0, 2}, {1.0, 1, 3}}).solvable());
  EXPECT_FALSE(ModeOperator(0.0, {{0.0, 1, 0}, {0.3, 1, 1}, {0.6, 1, 2}, {1.0, 1, 3}}).solvable());
}
