#include <gtest/gtest.h>

#include <random>

#include "ActionFit.h"
#include "CaptureParser.h"
#include "CaptureWriter.h"
#include "FacialActions.h"

using namespace mien;

namespace {

FAPMask everything() {
  return FAPMask().set();
}

/// Slope of the minimised sum in each strength, by the definition in the header: 0 inside, not negative at 0, not
/// positive at 1.
void expectMinimum(const ActionFit& fit, const FAPFrame& frame, Eigen::VectorXd x) {
  const auto value = [&](const Eigen::VectorXd& at) { return fit.loss(frame, at) + 1e-4 * at.squaredNorm(); };
  const double step = 1e-4;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd up = x, down = x;
    up(i) += step;
    down(i) -= step;
    const double slope = (value(up) - value(down)) / (2.0 * step);
    EXPECT_TRUE(x(i) > 1.0 - step || slope > -1e-6) << i << ": " << slope;
    EXPECT_TRUE(x(i) < step || slope < 1e-6) << i << ": " << slope;
  }
}

}  // namespace

TEST(ActionFit, IsTheMinimumWithinItsBounds) {
  const FacialActionMap map = bundledFacialActions();
  const ActionFit fit(map.blendshapes, everything());
  std::mt19937 random(3);
  std::normal_distribution<double> value(0.0, 300.0);
  for (int trial = 0; trial < 20; ++trial) {
    FAPFrame frame;
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) frame.setValue(fap, value(random));
    const Eigen::VectorXd x = fit.solve(frame);
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_LE(x.maxCoeff(), 1.0);
    expectMinimum(fit, frame, x);
  }
}

TEST(ActionFit, WhatActionsCanSayIsSaid) {
  const FacialActionMap map = bundledFacialActions();
  const ActionFit fit(map.blendshapes, everything());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> strength(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::VectorXd given(map.blendshapes.size());
    for (double& one : given) one = strength(random) < 0.7 ? 0.0 : strength(random);
    const FAPFrame frame = fit.framesOf(given);
    EXPECT_LT(fit.loss(frame, fit.solve(frame)), 1e-3 * fit.movement(frame) + 1e-12);
  }
}

TEST(ActionFit, SingleActionsComeBackAlone) {
  const FacialActionMap map = bundledFacialActions();
  const ActionFit fit(map.blendshapes, everything());
  for (const char* name : {"eyeBlinkLeft", "browInnerUp", "mouthSmileRight", "cheekPuff", "jawForward", "tongueOut"}) {
    const auto index = findAction(map.blendshapes, name) - map.blendshapes.data();
    const Eigen::VectorXd x = fit.solve(fit.framesOf(Eigen::VectorXd::Unit(map.blendshapes.size(), index) * 0.6));
    EXPECT_NEAR(x(index), 0.6, 0.01) << name;
    EXPECT_NEAR(x.sum(), 0.6, 0.02) << name;
  }
}

TEST(CaptureWriter, EveryStyleReadsBackNearToWhatItSays) {
  const FacialActionMap map = bundledFacialActions();
  FAPSequence sequence;
  sequence.framesPerSecond = 25.0;
  for (int i = 0; i < 60; ++i) {
    FAPFrame frame;
    frame.number = i;
    for (const auto& [fap, value] : findAction(map.actionUnits, "AU12")->faps) frame.setValue(fap, value * i / 60.0);
    frame.setValue(48, 500.0 * i);
    sequence.frames.push_back(frame);
  }
  for (const CaptureStyle style : {CaptureStyle::FACS, CaptureStyle::OpenFace, CaptureStyle::LiveLinkFace}) {
    std::string text;
    CaptureLoss loss;
    ASSERT_EQ(writeCapture(sequence, style, map, text, loss), "");
    FAPSequence read;
    const CaptureKind kind = style == CaptureStyle::LiveLinkFace ? CaptureKind::Blendshapes : CaptureKind::ActionUnits;
    const auto error = parseCapture(text, kind, map, read);
    ASSERT_FALSE(error.has_value()) << error->line << ": " << error->message;
    EXPECT_EQ(read.framesPerSecond, 25.0);
    ASSERT_EQ(read.frames.size(), 60u);
    for (int i = 0; i < 60; ++i) {
      EXPECT_NEAR(read.frames[i].value(59), sequence.frames[i].value(59),
                  style == CaptureStyle::LiveLinkFace ? 40.0 : 4.0);
      EXPECT_NEAR(read.frames[i].value(48), 500.0 * i, style == CaptureStyle::FACS ? 100.0 : 0.5);
    }
  }
}

TEST(CaptureWriter, LiveLinkFaceHasItsColumns) {
  FAPSequence sequence;
  sequence.frames.resize(2);
  sequence.frames[1].setValue(64, 100.0);
  std::string text;
  CaptureLoss loss;
  ASSERT_EQ(writeCapture(sequence, CaptureStyle::LiveLinkFace, bundledFacialActions(), text, loss), "");
  const std::string header = text.substr(0, text.find('\n'));
  EXPECT_EQ(header.rfind("Timecode,BlendshapeCount,EyeBlinkLeft,EyeLookDownLeft,", 0), 0u) << header;
  EXPECT_NE(header.find(",TongueOut,HeadYaw,HeadPitch,HeadRoll,LeftEyeYaw,"), std::string::npos) << header;
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), 62);
  EXPECT_NE(text.find("\n00:00:00:02.400,61,"), std::string::npos) << text;
  EXPECT_EQ(loss.faps, (std::vector<int>{64}));
}
