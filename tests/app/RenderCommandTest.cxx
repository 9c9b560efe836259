#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "FaceStateText.h"
#include "PictureFile.h"
#include "Program.h"

namespace {

vtkSmartPointer<vtkImageData> render(const TemporaryFolder& folder, std::vector<std::string> options) {
  const std::string file = folder.file("face.png");
  options.insert(options.begin(), {"render", "-o", file});
  const Outcome outcome = runMien(options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  return readPicture(file);
}

TEST(RenderCommand, DrawsAFaceOfTheSizeAskedForWithoutADisplay) {
  const TemporaryFolder folder;
  const auto picture = render(folder, {"--size", "201x150"});
  EXPECT_EQ(picture->GetDimensions()[0], 201);
  EXPECT_EQ(picture->GetDimensions()[1], 150);
  EXPECT_EQ(picture->GetNumberOfScalarComponents(), 3);
  EXPECT_GT(shareUnlikeCorner(picture), 0.3);
  EXPECT_LT(shareUnlikeCorner(picture), 0.9);
}

TEST(RenderCommand, TheFaceKeepsClearOfTheBorderFromEverySide) {
  const TemporaryFolder folder;
  for (const char* view : {"front", "side", "left", "right", "back", "top", "45", "45-right", "-30:20"}) {
    const auto picture = render(folder, {"--size", "120x100", "--resolution", "56x40", "--view", view});
    const int* size = picture->GetDimensions();
    for (int x = 0; x < size[0]; ++x)
      for (int y = 0; y < size[1]; ++y) {
        const bool border = x == 0 || y == 0 || x == size[0] - 1 || y == size[1] - 1;
        ASSERT_TRUE(!border || *static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0)) == 255) << view;
      }
    EXPECT_GT(shareUnlikeCorner(picture), 0.2) << view;
  }
}

/// How many pixels there are from the left, the right, the bottom and the top of a picture to what is drawn.
std::array<int, 4> margins(vtkImageData* picture) {
  const int* size = picture->GetDimensions();
  std::array<int, 4> margin = {size[0], size[0], size[1], size[1]};
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x)
      if (picture->GetScalarComponentAsDouble(x, y, 0, 2) < 250.0)
        margin = {std::min(margin[0], x), std::min(margin[1], size[0] - 1 - x), std::min(margin[2], y),
                  std::min(margin[3], size[1] - 1 - y)};
  return margin;
}

TEST(RenderCommand, PicturesOfOneFaceHaveOneScaleUnlessItLeavesThem) {
  const TemporaryFolder folder;
  const auto drawn = [&](const std::vector<std::string>& options) {
    std::vector<std::string> all = {"render", "--size", "120x200", "-o", folder.file("a.png")};
    all.insert(all.end(), options.begin(), options.end());
    EXPECT_EQ(runMien(all).exitCode, 0);
    return margins(readPicture(folder.file("a.png")));
  };
  const auto neutral = drawn({}), open = drawn({"--set", "open_jaw=400"});
  for (const int side : {0, 1, 3}) EXPECT_NEAR(open[side], neutral[side], 1) << side;
  EXPECT_LT(open[2], neutral[2] - 3) << "the chin goes down, nothing else moves";
  const auto lying = drawn({"--set", "head_roll=157000"}),
             fitted = drawn({"--set", "head_roll=157000", "--zoom", "fit"});
  for (const int side : {0, 1, 2, 3}) EXPECT_GT(lying[side], 0) << "a head that leaves the picture is drawn smaller";
  EXPECT_GT(lying[0] + lying[1], fitted[0] + fitted[1]);
}

TEST(RenderCommand, TransparentPicturesHaveNoBackground) {
  const TemporaryFolder folder;
  const auto picture = render(folder, {"--size", "100x100", "--transparent"});
  ASSERT_EQ(picture->GetNumberOfScalarComponents(), 4);
  EXPECT_EQ(picture->GetScalarComponentAsDouble(0, 0, 0, 3), 0.0);
  EXPECT_EQ(picture->GetScalarComponentAsDouble(50, 50, 0, 3), 255.0);
}

TEST(RenderCommand, BackgroundHasTheColourAskedFor) {
  const TemporaryFolder folder;
  const auto picture = render(folder, {"--size", "60x60", "--background", "#204060"});
  EXPECT_EQ(picture->GetScalarComponentAsDouble(0, 0, 0, 0), 32.0);
  EXPECT_EQ(picture->GetScalarComponentAsDouble(0, 0, 0, 1), 64.0);
  EXPECT_EQ(picture->GetScalarComponentAsDouble(0, 0, 0, 2), 96.0);
}

TEST(RenderCommand, StylesAndColoursShow) {
  const TemporaryFolder folder;
  const std::vector<std::string> size = {"--size", "160x160"};
  const auto with = [&](std::vector<std::string> options) {
    options.insert(options.end(), size.begin(), size.end());
    return shareUnlikeCorner(render(folder, options));
  };
  EXPECT_LT(with({"--style", "wireframe", "--resolution", "11x8"}),
            0.9 * with({"--style", "both", "--resolution", "11x8"}));
  EXPECT_GT(with({"--color-by", "PatchId"}), 0.2);
  EXPECT_GT(with({"--color-by", "TextureCoordinates", "--curves"}), 0.2);
}

TEST(RenderCommand, ThePictureCarriesItsState) {
  const TemporaryFolder folder;
  render(folder, {"--size", "40x40", "--scheme", "tangent", "--resolution", "29x20"});
  const std::string bytes = readTextFile(folder.file("face.png"));
  const size_t begin = bytes.find("{", bytes.find("MienFaceState"));
  ASSERT_NE(begin, std::string::npos);
  const std::string text = bytes.substr(begin, bytes.find("\n}", begin) + 2 - begin);
  mien::FaceState state;
  ASSERT_EQ(mien::readFaceState(text, state), "") << text;
  EXPECT_EQ(state.surface.scheme, "tangent");
  EXPECT_EQ(state.rows, 29);
}

TEST(RenderCommand, DrawsMeshesOfEveryFormatAlike) {
  const TemporaryFolder folder;
  const auto inner = [&](const std::string& mesh, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {mesh, "--size", "80x80"});
    const auto picture = render(folder, options);
    double sum = 0.0;
    for (int y = 30; y < 50; ++y)
      for (int x = 30; x < 50; ++x) sum += picture->GetScalarComponentAsDouble(x, y, 0, 1) / 400.0;
    return sum;
  };
  double first = 0.0;
  for (const char* ending : {"ply", "obj", "stl", "off", "vtp", "vts"}) {
    const std::string file = folder.file(std::string("face.") + ending);
    ASSERT_EQ(runMien({"surface", "-o", file}).exitCode, 0) << ending;
    const double seen = inner(file);
    if (first == 0.0) first = seen;
    EXPECT_GT(seen, 120.0) << ending << ": outsides are lit, insides are dark";
    EXPECT_NEAR(seen, first, 4.0) << ending;
  }
  EXPECT_LT(inner(folder.file("face.vtp"), {"--color-by", "PatchId"}), first - 10.0);
  EXPECT_GT(shareUnlikeCorner(render(folder, {folder.file("face.off"), "--style", "wireframe", "--size", "80x80"})),
            0.1);
}

TEST(RenderCommand, SaysWhatIsNoFaceAndWhatIsNoMesh) {
  const TemporaryFolder folder;
  const std::string mesh = folder.file("face.ply"), picture = folder.file("face.png");
  ASSERT_EQ(runMien({"surface", "-o", mesh}).exitCode, 0);
  const Outcome face = runMien({"render", "--face", mesh, "-o", picture});
  EXPECT_EQ(face.exitCode, 1);
  for (const char* word : {"face.ply", ".vtp", ".mienz", "mien acquire"})
    EXPECT_NE(face.errors.find(word), std::string::npos) << face.errors;
  const Outcome moved = runMien({"render", mesh, "--expression", "joy", "-o", picture});
  EXPECT_EQ(moved.exitCode, 2);
  EXPECT_NE(moved.errors.find("mien acquire"), std::string::npos) << moved.errors;
  ASSERT_EQ(runMien({"curves", "-o", folder.file("curves.vtp")}).exitCode, 0);
  const Outcome curves = runMien({"render", folder.file("curves.vtp"), "-o", picture});
  EXPECT_EQ(curves.exitCode, 1);
  EXPECT_NE(curves.errors.find("--face"), std::string::npos) << curves.errors;
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(RenderCommand, WrongValuesAreRefused) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--view", "inside"}, "front, side"}, {{"--size", "0x5"}, "56x40"},       {{"--size", "9000x5"}, "8192"},
      {{"--style", "oil"}, "wireframe"},     {{"--background", "blurple"}, "#"}, {{"--color-by", "Mood"}, "PatchId"},
  };
  for (const auto& [options, part] : cases) {
    std::vector<std::string> arguments = {"render", "-o", folder.file("x.png")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runMien(arguments);
    EXPECT_EQ(outcome.exitCode, 2) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(runMien({"render", "-o", folder.file("x.bmp")}).exitCode, 2);
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

}  // namespace
