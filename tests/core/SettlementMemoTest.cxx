#include "SettlementMemo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

#include "ProfileSettlement.h"

namespace {

using mien::SettlementMemo;

TEST(SettlementMemo, AnswersWhatItWasToldAndNothingElse) {
  SettlementMemo memo;
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(5, 0.0, 1.0);
  SettlementMemo::Answer answer;
  EXPECT_FALSE(memo.find({1.0, 2.0}, answer));
  memo.keep({1.0, 2.0}, {weights});
  ASSERT_TRUE(memo.find({1.0, 2.0}, answer));
  ASSERT_EQ(answer.size(), 1u);
  EXPECT_EQ(answer[0], weights);
  for (const SettlementMemo::Question& other :
       {SettlementMemo::Question{1.0}, {1.0, 2.0, 0.0}, {2.0, 1.0}, {1.0, 2.0 + 1e-15}})
    EXPECT_FALSE(memo.find(other, answer));
}

TEST(SettlementMemo, StaysSmall) {
  SettlementMemo memo;
  const int size = static_cast<int>(SettlementMemo::mostNumbers / 4);
  SettlementMemo::Answer answer;
  for (double i = 0.0; i < 9.0; ++i) {
    memo.keep({i}, {Eigen::VectorXd::Constant(size, i)});
    ASSERT_TRUE(memo.find({i}, answer)) << i;
    EXPECT_EQ(answer[0][size - 1], i);
  }
  EXPECT_FALSE(memo.find({0.0}, answer));
  memo.keep({-1.0}, {Eigen::VectorXd::Zero(5 * size)});
  EXPECT_FALSE(memo.find({-1.0}, answer)) << "more than it may hold";
  EXPECT_TRUE(memo.find({8.0}, answer)) << "which is no reason to forget the rest";
}

/// A bump over a few of 40 samples, whose feature point lies between two of them.
Eigen::VectorXd settled(double height) {
  constexpr int samples = 40;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(samples);
  for (int i = 0; i < 5; ++i) weights[8 + i] = height * (1.0 - 0.3 * std::abs(i - 2));
  Eigen::MatrixXd conditions = Eigen::MatrixXd::Zero(1, samples);
  conditions(0, 10) = 0.7;
  conditions(0, 11) = 0.3;
  mien::ProfileSettlement settlement = mien::ProfileSettlement::alone();
  settlement.share({settlement.add(weights, conditions, {10.3}, false)});
  settlement.settle();
  return settlement.weights(0);
}

TEST(SettlementMemo, ASettlementIsTheSameWhetherItIsRememberedOrNot) {
  const Eigen::VectorXd first = settled(0.9), other = settled(0.5), again = settled(0.9);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
  EXPECT_NEAR(0.7 * first[10] + 0.3 * first[11], 1.0, 1e-9) << "it meets its feature point";
  EXPECT_NEAR(0.7 * other[10] + 0.3 * other[11], 1.0, 1e-9);
}

TEST(SettlementMemo, ServesSeveralThreads) {
  const Eigen::VectorXd expected = settled(0.8);
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 20; ++i) {
        settled(0.1 + 0.01 * (20 * t + i));
        wrong[t] += settled(0.8) != expected;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

}  // namespace
