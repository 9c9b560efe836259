#include <gtest/gtest.h>

#include <filesystem>

#include "LandmarkTable.h"
#include "TextFile.h"

using namespace mien;

/// The files are called lineN_what.csv, N being the line that must be named.
TEST(LandmarkMalformed, EveryFileIsRefusedWithItsLineAndNothingIsLoaded) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/landmarks")) {
    const std::string name = entry.path().filename().string();
    LandmarkTable table;
    table.vertices[5] = 55;
    const std::string fault = parseLandmarks(readTextFile(entry.path().string()), table);
    EXPECT_EQ(fault.rfind(name.substr(4, name.find('_') - 4) + ": ", 0), 0u) << name << ": " << fault;
    EXPECT_GT(fault.size(), 25u) << name;
    EXPECT_EQ(table.vertices[5], 55) << name;
    EXPECT_FALSE(table.given[0]) << name;
    ++files;
  }
  EXPECT_EQ(files, 24);
}
