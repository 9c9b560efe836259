#include <gtest/gtest.h>

#include "FaceFiles.h"
#include "FaceLayout.h"
#include "Program.h"

namespace {

mien::FaceCurves faceFrom(const std::string& name) {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  mien::FaceCurves face;
  EXPECT_EQ(mien::readFaceCurves(reader->GetOutput(), face), "");
  return face;
}

TEST(EditCommand, MovesPointsOnBothSides) {
  const TemporaryFolder folder;
  const std::string output = folder.file("raised.vtp");
  const Outcome outcome = runMien({"edit", "--feature", "4.1", "--move", "0,2,1", "--mirror", "--spread", "2",
                                   "--curve", "C15", "--v", "3.14159265358979", "--move", "0,0,-3", "-o", output});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const mien::FaceCurves edited = faceFrom(output), neutral = genericFace();
  EXPECT_NEAR(edited.curves.curve(14)(20, 2) - neutral.curves.curve(14)(20, 2), -3.0, 1e-6);
  for (const char* id : {"4.1", "4.2"}) {
    const mien::FeaturePoint* p = neutral.feature(id);
    EXPECT_NEAR(edited.curves.at(p->curve, p->v).y() - neutral.curves.at(p->curve, p->v).y(), 2.0, 0.2) << id;
  }
  EXPECT_EQ(edited.features.size(), neutral.features.size());
}

TEST(EditCommand, WrongUseIsRefusedAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string output = folder.file("face.vtp");
  const auto refused = [&](std::vector<std::string> words, const std::string& part, int code = 2) {
    words.insert(words.begin(), "edit");
    words.insert(words.end(), {"-o", output});
    const Outcome outcome = runMien(words);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  };
  refused({}, "no edit");
  refused({"--curve", "C6", "--move", "0,1,0"}, "--v");
  refused({"--curve", "C6", "--v", "3"}, "--move");
  refused({"--curve", "C66", "--v", "3", "--move", "0,1,0"}, "C66");
  refused({"--feature", "77.1", "--move", "0,1,0"}, "77.1");
  refused({"--curve", "C6", "--v", "9", "--move", "0,1,0"}, "2 pi");
  refused({"--curve", "C6", "--v", "3", "--move", "0,1"}, "three numbers");
  refused({"--curve", "C6", "--v", "3", "--move", "0,1,0", "--width", "2"}, "width");
  refused({"--move", "0,1,0"}, "begin each");
  refused({"--curve", "C6", "--v", "3.1416", "--move", "0,60,0"}, "C5");
  refused({"--curve", "C6", "--v", "3", "--move", "0,1,0", "--move", "0,1,0"}, "twice");
  refused({"--face", folder.file("none.vtp"), "--curve", "C6", "--v", "3", "--move", "0,1,0"}, "none.vtp", 1);
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

}  // namespace
