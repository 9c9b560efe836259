#include <gtest/gtest.h>

#include "FaceStateText.h"
#include "PictureFile.h"
#include "Program.h"
#include "WarpMeshText.h"

namespace {

const std::string painted = MIEN_DATA_DIR "/textures/painted.png";
const std::string sevenBySeven = MIEN_DATA_DIR "/textures/painted_7x7.csv";

Outcome runWell(std::vector<std::string> arguments) {
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  return outcome;
}

double redness(vtkImageData* picture, double across, double up) {
  const int* size = picture->GetDimensions();
  const int x = static_cast<int>(across * size[0]), y = static_cast<int>(up * size[1]);
  return picture->GetScalarComponentAsDouble(x, y, 0, 0) / (1.0 + picture->GetScalarComponentAsDouble(x, y, 0, 1));
}

}  // namespace

TEST(TextureCommand, WarpsAPhotographOntoTheFace) {
  const TemporaryFolder folder;
  const std::string file = folder.file("texture.png");
  for (const std::string& mesh : {std::string(MIEN_DATA_DIR "/textures/painted.csv"), sevenBySeven}) {
    runWell({"texture", painted, "--source", mesh, "-o", file, "--size", "800x400"});
    const auto picture = readPicture(file);
    ASSERT_EQ(picture->GetDimensions()[0], 800);
    ASSERT_EQ(picture->GetDimensions()[1], 400);
    const double lip = redness(picture, 0.5, 1.0 - 21.5 / 27.0), skin = redness(picture, 0.5, 1.0 - 2.0 / 27.0);
    EXPECT_GT(lip, 1.15 * skin) << "the lower lip lies between C22' and C23";
  }
}

TEST(TextureCommand, AMeshOntoItselfGivesTheImage) {
  const TemporaryFolder folder;
  runWell({"texture", painted, "--source", sevenBySeven, "--target", sevenBySeven, "-o", folder.file("same.png")});
  const auto before = readPicture(painted), after = readPicture(folder.file("same.png"));
  ASSERT_EQ(before->GetDimensions()[0], after->GetDimensions()[0]);
  double largest = 0.0;
  for (int y = 120; y < before->GetDimensions()[1] - 60;
       ++y)  // within the mesh, which ends at the chin and before the ears
    for (int x = 130; x < before->GetDimensions()[0] - 130; ++x)
      largest = std::max(largest, std::abs(before->GetScalarComponentAsDouble(x, y, 0, 0) -
                                           after->GetScalarComponentAsDouble(x, y, 0, 0)));
  EXPECT_LE(largest, 1.0);
}

TEST(TextureCommand, MakesMeshesFromLandmarks) {
  const TemporaryFolder folder;
  mien::WarpMesh mesh;
  ASSERT_EQ(mien::parseWarpMesh(readTextFile(sevenBySeven), mesh), "");
  std::string text = "landmark,x,y\n";
  for (int i = 0; i < 49; ++i)
    if (!mesh.names[i].empty())
      text += mesh.names[i] + "," + std::to_string(mesh.x(i / 7, i % 7)) + "," + std::to_string(mesh.y(i / 7, i % 7)) +
              "\n";
  writeTextFile(folder.file("points.csv"), text);
  runWell({"texture", painted, "--landmarks", folder.file("points.csv"), "--mesh", "7x7", "--save-source",
           folder.file("a.csv"), "--save-target", folder.file("b.csv")});
  mien::WarpMesh made;
  ASSERT_EQ(mien::parseWarpMesh(readTextFile(folder.file("a.csv")), made), "");
  for (int i = 0; i < 49; ++i)
    if (!mesh.names[i].empty()) {
      EXPECT_NEAR(made.x(i / 7, i % 7), mesh.x(i / 7, i % 7), 1e-3);
      EXPECT_NEAR(made.y(i / 7, i % 7), mesh.y(i / 7, i % 7), 1e-3);
    }
  runWell({"texture", painted, "--landmarks", folder.file("points.csv"), "--save-source", folder.file("fine.csv")});
  ASSERT_EQ(mien::parseWarpMesh(readTextFile(folder.file("fine.csv")), made), "");
  EXPECT_EQ(made.rows(), 19);
}

TEST(TextureCommand, ShowsWhereThePointsLie) {
  const TemporaryFolder folder;
  const std::string drawn = folder.file("points.png");
  runWell({"texture", painted, "--source", sevenBySeven, "--show-points", drawn});
  const auto picture = readPicture(drawn);
  const int width = picture->GetDimensions()[0];
  EXPECT_NEAR(width, 1024, 2);
  mien::WarpMesh mesh;
  ASSERT_EQ(mien::parseWarpMesh(readTextFile(sevenBySeven), mesh), "");
  const double share = mesh.x(3, 3) / mesh.width, up = 1.0 - mesh.y(3, 3) / mesh.height;
  EXPECT_GT(redness(picture, share, up), 1.8) << "an orange mark on the nose ridge";
  writeTextFile(folder.file("far.csv"), "landmark,x,y\n5.4,2,2\n");
  runWell({"texture", painted, "--landmarks", folder.file("far.csv"), "--show-points", folder.file("far.svg")});
  EXPECT_NE(readTextFile(folder.file("far.svg")).find(">5.4<"), std::string::npos) << "what is wrong is seen as well";
}

TEST(TextureCommand, WrongFilesAndValuesAreRefused) {
  const TemporaryFolder folder;
  const std::string output = folder.file("x.png"),
                    folded = MIEN_TEST_DIR "/data/malformed/warp_mesh/line6_folded_columns.csv";
  writeTextFile(folder.file("cut.png"), readTextFile(painted).substr(0, 9000));
  const auto expect = [&](std::vector<std::string> arguments, int code, const std::string& part) {
    arguments.insert(arguments.begin(), "texture");
    const Outcome outcome = runMien(arguments);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  };
  expect({painted, "--source", folded, "-o", output}, 1,
         folded + ":6: the mesh is folded: columns 1 and 2 cross in row 2");
  expect({folder.file("cut.png"), "--source", sevenBySeven, "-o", output}, 1, "cut.png: it is damaged or cut off");
  expect({folder.file("none.png"), "--source", sevenBySeven, "-o", output}, 1, "none.png: it cannot be opened");
  expect({folder.file("cut.png"), "-o", output}, 2, "cut.csv");
  expect({painted}, 2, "nothing to write");
  expect({painted, "--source", sevenBySeven, "--show-points", folder.file("x.gif")}, 2, ".gif");
  expect({painted, "-o", folder.file("x.bmp")}, 2, ".bmp");
  expect({painted, "-o", output, "--size", "99999x5"}, 2, "32768");
  mien::WarpMesh wide;
  ASSERT_EQ(mien::parseWarpMesh(readTextFile(sevenBySeven), wide), "");
  wide.x *= 40000.0 / wide.width;
  wide.width = 40000.0;
  const TemporaryFolder elsewhere;
  writeTextFile(elsewhere.file("wide.csv"), mien::writeWarpMesh(wide));
  expect({painted, "--target", elsewhere.file("wide.csv"), "--source", sevenBySeven, "-o", output}, 1,
         "wide.csv: the mesh is for a picture of 40000 x");
  expect({painted, "-o", output, "--save-target", "/no/such/folder/mesh.csv"}, 1, "/no/such/folder");
  expect({painted, "-o", output, "--mesh", "7x7"}, 2, "--landmarks");
  expect({painted, "-o", output, "--source", sevenBySeven, "--landmarks", "x.csv"}, 2, "give one");
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

TEST(TextureCommand, RenderShowsTheTextureAndKeepsItInItsState) {
  const TemporaryFolder folder;
  const std::string plain = folder.file("plain.png"), file = folder.file("face.png");
  const std::vector<std::string> small = {"--size", "120x140", "--resolution", "56x40"};
  const auto render = [&](const std::string& output, std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "-o", output});
    options.insert(options.end(), small.begin(), small.end());
    return runWell(options);
  };
  render(plain, {});
  render(file, {"--texture", painted + ":" + sevenBySeven});
  EXPECT_GT(redness(readPicture(file), 0.5, 0.23), 1.25 * redness(readPicture(plain), 0.5, 0.23)) << "the lower lip";
  const std::string bytes = readTextFile(file);
  const size_t begin = bytes.find("{", bytes.find("MienFaceState"));
  mien::FaceState state;
  ASSERT_EQ(mien::readFaceState(bytes.substr(begin, bytes.find("\n}", begin) + 2 - begin), state), "");
  EXPECT_EQ(state.texture, painted);
  EXPECT_EQ(state.textureMesh, sevenBySeven);
}

TEST(TextureCommand, RenderRefusesTexturesThatCannotBe) {
  const TemporaryFolder folder;
  const auto expect = [&](std::vector<std::string> options, int code, const std::string& part) {
    options.insert(options.begin(), {"render", "--resolution", "29x20", "-o", folder.file("x.png")});
    const Outcome outcome = runMien(options);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  };
  expect({"--texture", "none.png"}, 1, "none.png: it cannot be opened");
  expect({"--texture", "painted", "--texture-mesh", "none.csv"}, 1, "none.csv: it cannot be opened");
  expect({"--texture-mesh", sevenBySeven}, 2, "--texture");
  expect({"--texture", "painted", "--color-by", "PatchId"}, 2, "give one");
  expect({"--texture", "painted", "--style", "wireframe"}, 2, "wireframe");
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}
