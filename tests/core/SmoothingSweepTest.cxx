#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "RandomCurves.h"
#include "SmoothingSweep.h"
#include "SurfaceJet.h"
#include "TurnedArea.h"

using namespace mien;

namespace {

SmoothingSweepOptions smallSweep() {
  SmoothingSweepOptions options;
  options.schemes = {"four-curve", "spline"};
  options.smoothing = {0.5, 1.0, 3.0, 100.0};
  options.rows = 29;
  options.columns = 24;
  return options;
}

double valueOf(const SweepRecord& record, const char* measure) {
  return record.values[sweepMeasure(measure)];
}

}  // namespace

TEST(SmoothingSweep, MeasuresEverySchemeAtEveryA) {
  const auto records = smoothingSweep(randomFace(), smallSweep());
  ASSERT_TRUE(records);
  ASSERT_EQ(records->size(), 8u);
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_EQ((*records)[i].scheme, i < 4 ? "four-curve" : "spline");
    EXPECT_EQ((*records)[i].smoothing, smallSweep().smoothing[i % 4]);
  }
  EXPECT_EQ(valueOf((*records)[5], "max_departure_mm"), 0.0);  // the reference is a = 1
  EXPECT_GT(valueOf((*records)[4], "max_departure_mm"), 0.0);
  EXPECT_GT(valueOf((*records)[4], "max_departure_mm"), valueOf((*records)[4], "rms_departure_mm"));
  EXPECT_LT(valueOf((*records)[5], "g1_max_deg"), 1e-6);
  EXPECT_TRUE(std::isnan(valueOf((*records)[5], "distance_rms_mm")));
}

TEST(SmoothingSweep, WhatASchemeRefusesIsARecordWithItsReason) {
  const auto records = smoothingSweep(randomFace(), smallSweep());
  ASSERT_TRUE(records);
  const SweepRecord& refused = (*records)[3];  // four-curve at a = 100
  EXPECT_NE(refused.reason.find("a (N + 1) = 250"), std::string::npos);
  for (const double value : refused.values) EXPECT_TRUE(std::isnan(value));
  EXPECT_EQ((*records)[7].reason, "");
  EXPECT_TRUE(std::isfinite(valueOf((*records)[7], "area_mm2")));
}

TEST(SmoothingSweep, ThreadsChangeNothing) {
  SmoothingSweepOptions options = smallSweep();
  const FaceCurves face = randomFace();
  const auto one = smoothingSweep(face, options);
  options.threads = 4;
  const auto four = smoothingSweep(face, options);
  ASSERT_TRUE(one && four);
  for (size_t i = 0; i < one->size(); ++i)
    EXPECT_EQ(std::memcmp((*one)[i].values.data(), (*four)[i].values.data(), (*one)[i].values.size() * sizeof(double)),
              0)
        << i;
}

/// The other threads wait with their first record until the question that ends the work has been asked; else they could
/// finish it all before.
TEST(SmoothingSweep, CancelledHalfWayLeavesNothing) {
  for (const int threads : {1, 3}) {
    SmoothingSweepOptions options = smallSweep();
    options.threads = threads;
    std::atomic<int> asked{0};
    double last = 0.0;
    const auto asker = std::this_thread::get_id();
    options.distance = [&](const FaceSample&) {
      while (std::this_thread::get_id() != asker && asked < 2) std::this_thread::yield();
      return 0.0;
    };
    const auto records = smoothingSweep(randomFace(), options, [&](double share) {
      EXPECT_GT(share, last);
      last = share;
      return ++asked < 2;
    });
    EXPECT_FALSE(records);
    EXPECT_EQ(asked, 2);
  }
}

/// Also where the thread that asks has nothing left to do and the others still work.
TEST(SmoothingSweep, ProgressRunsToTheEndAndCanBeStoppedUntilThen) {
  for (const bool stops : {false, true}) {
    SmoothingSweepOptions options = smallSweep();
    options.threads = 3;
    const auto asker = std::this_thread::get_id();
    options.distance = [&](const FaceSample&) {
      if (std::this_thread::get_id() != asker) std::this_thread::sleep_for(std::chrono::milliseconds(100));
      return 0.0;
    };
    double last = 0.0;
    const auto records = smoothingSweep(randomFace(), options, [&](double share) {
      last = share;
      return !stops || share < 1.0;
    });
    EXPECT_EQ(last, 1.0);
    EXPECT_EQ(!records, stops);
  }
}

TEST(SmoothingSweep, AsksForDistancesWhereItCan) {
  SmoothingSweepOptions options = smallSweep();
  options.distance = [](const FaceSample& sample) { return sample.point(0, 0).norm(); };
  const auto records = smoothingSweep(randomFace(), options);
  ASSERT_TRUE(records);
  EXPECT_GT(valueOf((*records)[0], "distance_rms_mm"), 50.0);
  EXPECT_TRUE(std::isnan(valueOf((*records)[3], "distance_rms_mm")));
}

TEST(SmoothingSweep, AnExceptionOfAnyThreadReachesTheCaller) {
  for (const int threads : {1, 2, 1000000}) {
    SmoothingSweepOptions options = smallSweep();
    options.threads = threads;
    options.distance = [](const FaceSample&) -> double { throw std::runtime_error("no distance"); };
    EXPECT_THROW(smoothingSweep(randomFace(), options), std::runtime_error) << threads;
  }
}

TEST(SmoothingSweep, FaultsSayWhatIsAllowed) {
  const auto fault = [](auto change) {
    SmoothingSweepOptions options = smallSweep();
    change(options);
    return describeFault(options, 40);
  };
  EXPECT_EQ(fault([](auto&) {}), "");
  EXPECT_NE(fault([](auto& o) { o.schemes.push_back("five"); }).find("no scheme 'five'"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.schemes.clear(); }).find("at least one"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.smoothing.push_back(0.0); }).find("0 < a"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.smoothing.clear(); }).find("at least one"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.surface.modes = 99; }).find("0 .. 20"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.rows = 5; }).find("5x24"), std::string::npos);
  EXPECT_NE(fault([](auto& o) { o.reference = -1.0; }).find("0 < a"), std::string::npos);
}

TEST(TurnedArea, IsTheShareOfTheFrontWhereNormalsOppose) {
  // A cylinder along y and its mirror image at the same (u, v): normals oppose where |v| < 45 degrees, and the front,
  // z > 50 mm, is where |v| < 60 degrees.
  const auto cylinder = [](double side) {
    return [side](int patch, double u, double v) {
      SurfaceJet jet;
      jet.s = {side * 100.0 * std::sin(v), -20.0 * (patch + u), 100.0 * std::cos(v)};
      jet.su = {0.0, -20.0, 0.0};
      jet.sv = {side * 100.0 * std::cos(v), 0.0, -100.0 * std::sin(v)};
      return jet;
    };
  };
  const FaceSample plain(cylinder(1.0), 29, 722), mirrored(cylinder(-1.0), 29, 722);
  EXPECT_EQ(turnedAreaShare(plain, plain), 0.0);
  EXPECT_NEAR(turnedAreaShare(mirrored, plain), 0.75, 0.005);
}
