#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "FaceFiles.h"
#include "Program.h"

namespace {

/// The landmarks of the generic face as those of a photograph: 3 pixels per mm, y downwards; the chin dropped by so
/// many mm.
std::string writePhotograph(const std::string& name, double chinDrop = 0.0) {
  std::ifstream known(MIEN_DATA_DIR "/faces/generic68.csv");
  std::ofstream file(name);
  file << "landmark,x,y\n";
  std::string line;
  std::getline(known, line);
  while (std::getline(known, line)) {
    std::istringstream cells(line);
    char comma;
    int landmark;
    double x, y;
    cells >> landmark >> comma >> x >> comma >> y;
    file << landmark << "," << 500.0 + 3.0 * x << "," << 400.0 - 3.0 * (y - (landmark == 8 ? chinDrop : 0.0)) << "\n";
  }
  return name;
}

TEST(AdaptCommand, TheGenericFacesOwnPictureGivesItBack) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runMien({"adapt", writePhotograph(folder.file("p.csv")), "-o", folder.file("face.vtp"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("\"y_down\": true"), std::string::npos) << outcome.output;
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->SetFileName(folder.file("face.vtp").c_str());
  reader->Update();
  mien::FaceCurves face;
  ASSERT_EQ(mien::readFaceCurves(reader->GetOutput(), face), "");
  EXPECT_LT((face.curves.points - genericFace().curves.points).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(AdaptCommand, WrongInputIsRefused) {
  const TemporaryFolder folder;
  const std::string output = folder.file("face.vtp"), picture = writePhotograph(folder.file("p.csv"));
  EXPECT_EQ(runMien({"adapt", picture, "-o", folder.file("face.obj")}).exitCode, 2);
  EXPECT_EQ(runMien({"adapt", picture, "--scale", "-1", "-o", output}).exitCode, 2);
  EXPECT_EQ(runMien({"adapt", picture, "--y-down", "--y-up", "-o", output}).exitCode, 2);
  const Outcome missing = runMien({"adapt", folder.file("none.csv"), "-o", output});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_NE(missing.errors.find("none.csv: "), std::string::npos) << missing.errors;
  const Outcome folded = runMien({"adapt", writePhotograph(folder.file("folded.csv"), -60.0), "-o", output});
  EXPECT_EQ(folded.exitCode, 1);
  EXPECT_NE(folded.errors.find("folded.csv: "), std::string::npos) << folded.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 2);
}

TEST(AdaptCommand, AListWithoutHeaderIsTheSamePicture) {
  const TemporaryFolder folder;
  const std::string text = readTextFile(writePhotograph(folder.file("p.csv")));
  writeTextFile(folder.file("bare.csv"), text.substr(text.find('\n') + 1));
  for (const char* const name : {"p", "bare"}) {
    const Outcome outcome =
        runMien({"adapt", folder.file(name + std::string(".csv")), "-o", folder.file(name + std::string(".vtp"))});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  }
  EXPECT_EQ(readTextFile(folder.file("bare.vtp")), readTextFile(folder.file("p.vtp")));
}

TEST(AdaptCommand, FaultsOfAListNameFileAndLine) {
  const TemporaryFolder folder;
  const std::string list = folder.file("list.csv");
  const auto faultOf = [&](const std::string& text) {
    writeTextFile(list, text);
    const Outcome outcome = runMien({"adapt", list, "-o", folder.file("face.vtp")});
    EXPECT_EQ(outcome.exitCode, 1);
    return outcome.errors;
  };
  EXPECT_EQ(faultOf("0,1,2\n1,1,two\n").rfind("mien: " + list + ":2: 'two' is no finite number", 0), 0u);
  EXPECT_EQ(faultOf("1,2\n3,4\n").rfind("mien: " + list + ":2: landmark 2 is missing", 0), 0u);
  EXPECT_EQ(faultOf("a,b,c\n1,2,3\n").rfind("mien: " + list + ":1: the header must name", 0), 0u);
  EXPECT_EQ(faultOf("").rfind("mien: " + list + ":1: ", 0), 0u);
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

}  // namespace
