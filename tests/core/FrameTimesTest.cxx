#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "FrameTimes.h"
#include "TimeCode.h"

using namespace mien;

namespace {

/// Frames whose FAP 3 is 100 times the time, so that mixing in time changes nothing.
FAPSequence linearFrames(const FrameTimes& times) {
  FAPSequence sequence;
  sequence.rateIsAssumed = true;
  for (const double time : times.seconds) {
    sequence.frames.emplace_back();
    sequence.frames.back().setValue(3, 100.0 * time);
  }
  return sequence;
}

FrameTimes at(const std::vector<double>& seconds) {
  FrameTimes times{seconds, {}};
  for (std::size_t i = 0; i < seconds.size(); ++i) times.lines.push_back(static_cast<int>(i) + 2);
  return times;
}

}  // namespace

TEST(FrameTimes, RoundedTimesGiveTheirWholeRate) {
  for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 120.0, 30000.0 / 1001.0}) {
    std::vector<double> seconds;
    for (int i = 0; i < 300; ++i) seconds.push_back(std::round(1000.0 * (17.3 + i / rate)) / 1000.0);
    const FrameTimes times = at(seconds);
    FAPSequence sequence = linearFrames(times);
    ASSERT_FALSE(times.place(sequence).has_value());
    EXPECT_DOUBLE_EQ(sequence.framesPerSecond, rate);
    EXPECT_EQ(sequence.frames.size(), 300u);
    EXPECT_TRUE(sequence.warnings.empty());
  }
}

TEST(FrameTimes, GapsAreFilledInTime) {
  const FrameTimes times = at({0.0, 0.1, 0.2, 0.6, 0.7, 1.0});
  FAPSequence sequence = linearFrames(times);
  ASSERT_FALSE(times.place(sequence).has_value());
  EXPECT_DOUBLE_EQ(sequence.framesPerSecond, 10.0);
  ASSERT_EQ(sequence.frames.size(), 11u);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(sequence.frames[i].value(3), 10.0 * i, 1e-9);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_NE(sequence.warnings[0].message.find("2 gaps"), std::string::npos) << sequence.warnings[0].message;
  EXPECT_EQ(sequence.warnings[0].line, 5);
}

/// Steps that jitter by up to 0.35 of a frame, some frames dropped, must give the rate of the recording and a frame for
/// each that was recorded or dropped.
TEST(FrameTimes, JitterAndDroppedRowsLeaveTheRate) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(-0.35, 0.35);
  for (const double rate : {24000.0 / 1001.0, 25.0, 30000.0 / 1001.0, 30.0, 50.0, 60000.0 / 1001.0, 60.0, 120.0})
    for (const int dropped : {0, 3}) {
      std::vector<double> seconds;
      for (int i = 0; i < 1200; ++i)
        if (dropped == 0 || i % 301 != 300) seconds.push_back(5.0 + (i + jitter(random)) / rate);
      const FrameTimes times = at(seconds);
      FAPSequence sequence = linearFrames(times);
      ASSERT_FALSE(times.place(sequence).has_value());
      EXPECT_DOUBLE_EQ(sequence.framesPerSecond, rate);
      EXPECT_EQ(sequence.frames.size(), 1200u) << rate;
      EXPECT_EQ(sequence.warnings.size(), dropped ? 1u : 0u) << rate;
    }
}

TEST(FrameTimes, RatesThatAreNotUsualStay) {
  for (const double rate : {12.5, 7.25, 61.3, 0.5}) {
    std::vector<double> seconds;
    for (int i = 0; i < 400; ++i) seconds.push_back(i / rate);
    const FrameTimes times = at(seconds);
    FAPSequence sequence = linearFrames(times);
    ASSERT_FALSE(times.place(sequence).has_value());
    EXPECT_NEAR(sequence.framesPerSecond, rate, 1e-9);
    EXPECT_EQ(sequence.frames.size(), 400u);
  }
}

/// Ten minutes of a camera at 59.97: taken as 60 it would end 18 frames late.
TEST(FrameTimes, AUsualRateIsNotTakenWhereItWouldDrift) {
  std::vector<double> seconds;
  for (int i = 0; i < 36000; ++i) seconds.push_back(std::round(1e6 * i / 59.97) / 1e6);
  const FrameTimes times = at(seconds);
  FAPSequence sequence = linearFrames(times);
  ASSERT_FALSE(times.place(sequence).has_value());
  EXPECT_DOUBLE_EQ(sequence.framesPerSecond, 59.97);
}

TEST(FrameTimes, TimeThatGoesBackOrJumpsFarIsRefused) {
  for (const auto& [seconds, line] : {std::pair{std::vector<double>{0.0, 0.1, 0.05}, 4}, {{0.0, 0.1, 0.2, 1e9}, 5}}) {
    const FrameTimes times = at(seconds);
    FAPSequence sequence = linearFrames(times);
    const auto error = times.place(sequence);
    ASSERT_TRUE(error.has_value());
    EXPECT_EQ(error->line, line);
    EXPECT_EQ(sequence.frames.size(), seconds.size());
  }
}

TEST(FrameTimes, AnotherRateKeepsTheMotion) {
  FAPSequence sequence = linearFrames(at({0.0, 0.1, 0.2, 0.3}));
  sequence.framesPerSecond = 10.0;
  const FAPSequence fine = resampled(sequence, 40.0).value();
  ASSERT_EQ(fine.frames.size(), 13u);
  for (int i = 0; i < 13; ++i) EXPECT_NEAR(fine.frames[i].value(3), 100.0 * i / 40.0, 1e-9);
  EXPECT_DOUBLE_EQ(fine.duration(), sequence.duration());
}

TEST(FrameTimes, MoreThanAMillionFramesAreNotMadeAndNotCut) {
  FAPSequence sequence = linearFrames(at({0.0, 0.1, 0.2, 0.3}));
  sequence.framesPerSecond = 0.01;  // 300 s
  EXPECT_EQ(resampled(sequence, 3333.0)->frames.size(), 999901u);
  EXPECT_FALSE(resampled(sequence, 3334.0).has_value());
}

TEST(TimeCode, ReadsWhatCamerasWrite) {
  const auto code = parseTimeCode("12:34:56:07.123");
  ASSERT_TRUE(code.has_value());
  EXPECT_DOUBLE_EQ(code->seconds, 12 * 3600 + 34 * 60 + 56);
  EXPECT_DOUBLE_EQ(code->frames, 7.123);
  EXPECT_DOUBLE_EQ(parseTimeCode("0:00:01.5")->seconds, 1.5);
  EXPECT_TRUE(parseTimeCode("01:00:00;02")->dropsNumbers);
  const double rate = 30000.0 / 1001.0;
  EXPECT_NEAR(secondsOf(*parseTimeCode("00:01:00;02"), rate) - secondsOf(*parseTimeCode("00:00:59;29"), rate),
              1.0 / rate, 1e-9);
  EXPECT_NEAR(secondsOf(*parseTimeCode("01:00:00;00"), rate), 3600.0, 0.01);
  for (const char* text :
       {"", "12", "12:34", "1:2:3:4:5", "12:34:60", "12:61:00:00", "a:b:c:d", "12:34:56:-1", "1.5:00:00:00", "::::"})
    EXPECT_FALSE(parseTimeCode(text).has_value()) << text;
}

TEST(TimeCode, TheRateIsTheUsualOneAboveTheLargestFrame) {
  EXPECT_EQ(rateOfTimeCodes(23.0, false), 24.0);
  EXPECT_EQ(rateOfTimeCodes(24.0, false), 25.0);
  EXPECT_EQ(rateOfTimeCodes(29.9, false), 30.0);
  EXPECT_EQ(rateOfTimeCodes(59.0, false), 60.0);
  EXPECT_EQ(rateOfTimeCodes(500.0, false), 501.0);
}
