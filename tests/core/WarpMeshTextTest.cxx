#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "ImageLandmarks.h"
#include "TextFile.h"
#include "WarpMeshText.h"

using namespace mien;

namespace {

/// The files are called lineN_what.csv, N being the line that must be named.
void expectRefusals(const std::string& folder, int atLeast,
                    const std::function<std::string(const std::string&)>& parse) {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(MIEN_TEST_DIR "/data/malformed/") + folder)) {
    const std::string name = entry.path().filename().string();
    const std::string fault = parse(readTextFile(entry.path().string()));
    const std::string line = name.substr(4, name.find('_') - 4) + ": ";
    EXPECT_EQ(fault.rfind(line, 0), 0u) << name << " gives '" << fault << "'";
    EXPECT_GT(fault.size(), 20u) << name;
    ++files;
  }
  EXPECT_GE(files, atLeast);
}

}  // namespace

TEST(WarpMeshText, WhatIsWrittenIsReadBackExactly) {
  WarpMesh mesh = evenMesh(3, 4, 640.5, 480.0);
  mesh.x(1, 1) += 0.1 + 0.2;
  mesh.y(1, 2) -= 1.0 / 3.0;
  for (const bool named : {false, true}) {
    if (named) mesh.names = {"", "a", "", "", "", "4.6", "b", "", "", "", "", "c"};
    WarpMesh read;
    ASSERT_EQ(parseWarpMesh(writeWarpMesh(mesh), read), "");
    EXPECT_EQ(read, mesh);
  }
}

TEST(WarpMeshText, ColumnsAndPointsMayStandInAnyOrder) {
  WarpMesh read;
  ASSERT_EQ(
      parseWarpMesh("\xEF\xBB\xBF# a "
                    "comment\nmien_warp_mesh,1,10,20\ny,x,column,row\r\n20,10,2,2\n20,0,1,2\n\n0,0,1,1\n0,10,2,1\n",
                    read),
      "");
  EXPECT_EQ(read, evenMesh(2, 2, 10, 20));
}

TEST(WarpMeshText, EveryMalformedFileIsRefusedWithItsLine) {
  expectRefusals("warp_mesh", 14, [](const std::string& text) {
    WarpMesh mesh = evenMesh(2, 2, 3, 3);
    const std::string fault = parseWarpMesh(text, mesh);
    EXPECT_EQ(mesh, evenMesh(2, 2, 3, 3)) << "touched";
    return fault;
  });
}

TEST(ImageLandmarks, EveryMalformedFileIsRefusedWithItsLine) {
  expectRefusals("image_landmarks", 7, [](const std::string& text) {
    ImageLandmarks landmarks = {{"before", {1, 2}}};
    const std::string fault = parseImageLandmarks(text, landmarks);
    EXPECT_EQ(landmarks.size(), 1u) << "touched";
    return fault;
  });
}

TEST(ImageLandmarks, NumbersAndNamesAreRead) {
  ImageLandmarks landmarks;
  ASSERT_EQ(parseImageLandmarks("# by hand\ny,landmark,x\n2.5,36,1\n4,brow_middle,3\n", landmarks), "");
  EXPECT_EQ(landmarks.at("36"), Eigen::Vector2d(1, 2.5));
  EXPECT_EQ(landmarks.at("brow_middle"), Eigen::Vector2d(3, 4));
}
