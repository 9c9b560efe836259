#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "CaseMeasures.h"
#include "FaceScheme.h"
#include "StudyText.h"
#include "TextFile.h"

namespace {

using namespace mien;

Study readOrFail(const std::string& text) {
  Study study;
  int line = 0;
  EXPECT_EQ(readStudy(text, study, line), "");
  return study;
}

TEST(StudyText, WithoutMembersIsTheGenericFaceAtRest) {
  const Study study = readOrFail("{\"mien_study\": 1}");
  EXPECT_EQ(study, Study());
  EXPECT_EQ(study.caseCount(), 1.0);
  EXPECT_EQ(study.measures, caseMeasureNames());
  EXPECT_TRUE(study.poses.at(0).isNeutral());
}

TEST(StudyText, EveryMemberIsRead) {
  const Study study = readOrFail(
      "{\"mien_study\": 1, \"faces\": [\"generic\", \"anna.vtp\"], \"schemes\": \"all\", \"a\": \"0.1:10:21log\","
      "\"harmonics\": \"2:8:4\", \"remainder\": false, \"expressions\": [\"neutral\", \"joy:0.25,anger\"],"
      "\"fap\": {\"file\": \"talk.fap\", \"frames\": [5, 10]}, \"resolution\": [56, 40], \"reference_a\": 0.5,"
      "\"measures\": [\"lebesgue\", \"area_mm2\"]}");
  EXPECT_EQ(study.faces, (std::vector<std::string>{"generic", "anna.vtp"}));
  EXPECT_EQ(study.schemes.size(), faceSchemes().size());
  ASSERT_EQ(study.smoothing.size(), 21u);
  EXPECT_EQ(study.smoothing.back(), 10.0);
  EXPECT_EQ(study.harmonics, (std::vector<int>{2, 4, 6, 8}));
  EXPECT_FALSE(study.remainder);
  ASSERT_EQ(study.poses.size(), 4u);
  EXPECT_EQ(study.poses[1].expressions, (std::map<std::string, double>{{"joy", 0.25}, {"anger", 1.0}}));
  EXPECT_TRUE(study.poses[3].isFrame);
  EXPECT_EQ(study.poses[3].frame, 10.0);
  EXPECT_EQ(study.rows, 56);
  EXPECT_EQ(study.columns, 40);
  EXPECT_EQ(study.referenceSmoothing, 0.5);
  EXPECT_EQ(study.measures, (std::vector<std::string>{"lebesgue", "area_mm2"}));
  EXPECT_EQ(study.caseCount(), 2.0 * 4.0 * 4.0 * 6.0 * 21.0);
  EXPECT_EQ(readOrFail(writeStudy(study)), study);
}

TEST(StudyText, AllFramesAreThoseOfTheAnimationEachNumberOnce) {
  Study study = readOrFail("{\"mien_study\": 1, \"fap\": {\"file\": \"talk.fap\"}}");
  EXPECT_TRUE(study.allFrames);
  EXPECT_EQ(readOrFail(writeStudy(study)), study);
  study.addAllFrames({3.0, 4.0, 4.0, 7.0});
  ASSERT_EQ(study.poses.size(), 3u);
  EXPECT_EQ(study.poses[2].frame, 7.0);
  study.addAllFrames({8.0});
  EXPECT_EQ(study.poses.size(), 3u);
}

TEST(StudyText, RangesOfWholeNumbersAreWhole) {
  for (const int count : {20, 137, 5000}) {
    const std::string range = "\"1:" + std::to_string(count) + ":" + std::to_string(count) + "\"";
    const Study study =
        readOrFail("{\"mien_study\": 1, \"harmonics\": " + range +
                   (count > 1000 ? "" : ", \"fap\": {\"file\": \"x\", \"frames\": " + range + "}") + "}");
    ASSERT_EQ(study.harmonics.size(), static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) EXPECT_EQ(study.harmonics[i], i + 1);
    if (count < 1000) {
      EXPECT_EQ(study.poses.at(11).frame, 12.0);
    }
  }
}

/// The first part of a file's name, up to -, is what the sentence must name.
TEST(StudyText, WhatIsMalformedIsRefusedByName) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/study")) {
    const std::string name = entry.path().stem().string();
    Study study;
    int line = 0;
    const std::string fault = readStudy(readTextFile(entry.path().string()), study, line);
    EXPECT_NE(fault.find(name.substr(0, name.find('-'))), std::string::npos) << name << ": " << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << name;
    EXPECT_LT(fault.size(), 900u) << name;
    EXPECT_EQ(line > 0, name.rfind("JSON-", 0) == 0) << name;
    EXPECT_EQ(study, Study()) << name;
    ++count;
  }
  EXPECT_GE(count, 30);
}

}  // namespace
