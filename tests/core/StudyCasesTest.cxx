#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <set>

#include "FaceSeams.h"
#include "SmoothingSweep.h"
#include "StudyTable.h"
#include "SyntheticFace.h"

namespace {

using namespace mien;

Study largeStudy() {
  Study study;
  study.faces = {"generic", "anna, the first.vtp", "a \"b\".vtp"};
  study.schemes = {"spline", "tangent"};
  study.smoothing.clear();
  for (int i = 0; i < 37; ++i) study.smoothing.push_back(0.1 + i / 7.0);
  study.harmonics = {3, 5};
  study.poses.push_back({"joy:0.3", {{"joy", 0.3}}, false, 0.0});
  study.poses.push_back({"", {}, true, 12.0});
  study.fapFile = "talk.fap";
  return study;
}

TEST(StudyCases, AreTheProductEachWithAnIdOfItsOwn) {
  const Study study = largeStudy();
  const StudyCases cases(study);
  ASSERT_EQ(cases.count(), 3 * 3 * 2 * 2 * 37);
  std::set<std::string> ids;
  for (std::int64_t i = 0; i < cases.count(); ++i) ids.insert(cases.at(i).id);
  EXPECT_EQ(static_cast<std::int64_t>(ids.size()), cases.count());
  const StudyCase last = cases.at(cases.count() - 1);
  EXPECT_EQ(last.state.curvesFile, "a \"b\".vtp");
  EXPECT_EQ(last.state.fapFile, "talk.fap");
  EXPECT_EQ(last.state.frame, 12.0);
  EXPECT_EQ(last.state.surface.scheme, "tangent");
  EXPECT_EQ(last.state.surface.modes, 5);
  EXPECT_EQ(last.state.surface.smoothing[8], study.smoothing.back());
}

TEST(StudyCases, KeepTheirIdInALargerStudy) {
  const Study study = largeStudy();
  Study other = study;
  other.schemes.insert(other.schemes.begin(), "four-curve");
  other.faces.insert(other.faces.begin(), "otto.vtp");
  std::set<std::string> ids;
  const StudyCases cases(study), more(other);
  for (std::int64_t i = 0; i < more.count(); ++i) ids.insert(more.at(i).id);
  for (std::int64_t i = 0; i < cases.count(); ++i) EXPECT_EQ(ids.count(cases.at(i).id), 1u);
}

TEST(StudyCases, BlocksCoverEachCaseOnceAndDifferInAAlone) {
  const Study study = largeStudy();
  const StudyCases cases(study);
  std::int64_t next = 0;
  for (std::int64_t i = 0; i < cases.blockCount(); ++i) {
    const StudyBlock block = cases.block(i);
    ASSERT_EQ(block.first, next);
    ASSERT_GT(block.last, block.first);
    ASSERT_LE(block.last - block.first, StudyCases::longestBlock);
    FaceState first = cases.at(block.first).state, last = cases.at(block.last - 1).state;
    first.surface.smoothing = last.surface.smoothing;
    ASSERT_EQ(first, last);
    next = block.last;
  }
  EXPECT_EQ(next, cases.count());
}

TEST(StudyCases, FilesLieBesideTheStudyUnlessTheirPathIsWhole) {
  Study study;
  study.folder = "studies";
  study.faces = {"anna.vtp", "/data/otto.vtp"};
  const StudyCases cases(study);
  EXPECT_EQ(cases.at(0).state.curvesFile, "studies/anna.vtp");
  EXPECT_EQ(cases.at(1).state.curvesFile, "/data/otto.vtp");
  const std::string id = cases.at(0).id;
  study.folder = "elsewhere";
  EXPECT_EQ(cases.at(0).id, id);
}

/// Any value, now and then none.
double randomValue(std::mt19937_64& random) {
  double value = 0.0;
  const std::uint64_t bits = random();
  std::memcpy(&value, &bits, sizeof value);
  return bits % 7 == 0 ? std::numeric_limits<double>::quiet_NaN() : value;
}

TEST(StudyTable, TellsItsRowsFromAllThatIsNone) {
  const Study study = largeStudy();
  const StudyCases cases(study);
  const StudyTable table(study, cases, "contents");
  std::mt19937_64 random(3);
  for (int i = 0; i < 200; ++i) {
    const StudyCase one = cases.at(static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(cases.count())));
    CaseValues measured = {{}, i % 5 == 0 ? "no, \"none\"\nat all" : ""};
    for (std::size_t m = 0; m < study.measures.size(); ++m) measured.values.push_back(randomValue(random));
    std::string row = table.row(one, measured);
    ASSERT_EQ(row.find('\n'), row.size() - 1);
    row.pop_back();
    ASSERT_EQ(table.caseOf(row), one.number) << row;
    if (!measured.reason.empty()) continue;  // one that is cut off looks like none, but that its line has no end
    for (std::size_t cut = 0; cut < row.size(); ++cut) {
      ASSERT_EQ(table.caseOf(row.substr(0, cut)), std::nullopt) << row.substr(0, cut);
      ASSERT_EQ(table.caseOf(row.substr(cut + 1)), std::nullopt) << row.substr(cut + 1);
    }
  }
}

TEST(StudyTable, TheHeadNamesFormatVersionAndStudy) {
  const Study study = largeStudy();
  const StudyCases cases(study);
  const std::string head = StudyTable(study, cases, "a").head();
  EXPECT_EQ(head.rfind("# mien ensemble table, version 1, study ", 0), 0u) << head;
  EXPECT_EQ(std::count(head.begin(), head.end(), '\n'), 2);
  EXPECT_NE(head, StudyTable(study, cases, "b").head()) << "other files are another study";
  Study other = study;
  other.rows += 1;
  EXPECT_NE(head.substr(0, 60), StudyTable(other, StudyCases(other), "a").head().substr(0, 60));
}

TEST(CaseMeasures, AreThoseOfTheirOwnClasses) {
  const FaceCurves face = SyntheticFace::make(40);
  FaceCurves moved = face;
  moved.curves.points.col(2).array() += 3.0;
  Study study;
  study.smoothing = {0.7};
  study.rows = 56;
  study.columns = 40;
  const StudyCases cases(study);
  const StudyCase one = cases.at(0);
  const CaseValues measured = CaseMeasures(study, one, moved, face).measure(0.7);
  const auto value = [&](const char* name) {
    const auto& names = study.measures;
    return measured.values.at(static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin()));
  };
  SmoothingSweepOptions sweep;
  sweep.surface = one.state.surface;
  sweep.schemes = {"spline"};
  sweep.smoothing = {0.7};
  sweep.rows = 56;
  sweep.columns = 40;
  const SweepRecord record = smoothingSweep(moved, sweep)->front();
  for (const std::string& name : sweepMeasureNames())
    if (name != "distance_rms_mm") {
      EXPECT_EQ(value(name.c_str()), sweepValue(record, name)) << name;
    }
  FaceSeams seams(one.state.surface, 40);
  seams.setCurves(moved.curves);
  SeamSummary all;
  for (int seam = 0; seam < FaceSeams::seamCount; ++seam) all.add(seams.whole(seam));
  EXPECT_EQ(value("seam_g1_mean_deg"), all.mean().g1);
  EXPECT_EQ(value("seam_c2_max"), all.max().c2);
  EXPECT_NEAR(value("motion_rms_mm"), 3.0, 1e-9);
  EXPECT_NEAR(value("motion_max_mm"), 3.0, 1e-9);
}

CaseValues measuredAtRest(const Study& study) {
  const FaceCurves face = SyntheticFace::make(40);
  return CaseMeasures(study, StudyCases(study).at(0), face, face).measure(study.smoothing[0]);
}

TEST(CaseMeasures, ThatAreNotWantedChangeNothing) {
  Study study;
  study.smoothing = {0.7};
  const CaseValues whole = measuredAtRest(study);
  const std::vector<std::string> all = study.measures;
  for (std::size_t i = 0; i < all.size(); ++i) {
    study.measures = {all[i]};
    const double alone = measuredAtRest(study).values.at(0);
    EXPECT_EQ(alone, whole.values[i]) << all[i];
  }
}

TEST(CaseMeasures, WithoutASurfaceHaveAReason) {
  Study study;
  study.harmonics = {21};
  const CaseValues measured = measuredAtRest(study);
  EXPECT_NE(measured.reason.find("N = 21"), std::string::npos) << measured.reason;
  for (const double value : measured.values) EXPECT_TRUE(std::isnan(value));
}

}  // namespace
