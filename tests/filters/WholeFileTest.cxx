#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "SmallDisk.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

namespace {

namespace fs = std::filesystem;
using mien::WholeFile;

std::string textOf(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST(WholeFile, WhatWasThereStaysWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string name = folder.file("session.json");
  ASSERT_EQ(WholeFile::write(name, "good"), "");
  for (const size_t size : {4097, 20000, 200000}) {
    const SmallDisk disk(4096);
    EXPECT_NE(WholeFile::write(name, std::string(size, 'x')), "") << size;
  }
  EXPECT_EQ(textOf(name), "good");
  EXPECT_EQ(std::distance(fs::directory_iterator(fs::path(name).parent_path()), {}), 1) << "a temporary file is left";
}

/// As VTK's of .ply and .obj.
TEST(WholeFile, AWriterThatDoesNotAskIsFoundOutWhereTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string name = folder.file("face.ply");
  ASSERT_EQ(WholeFile::write(name, "good"), "");
  for (const size_t size : {4096, 4097, 20000, 200000}) {
    const SmallDisk disk(4096);
    WholeFile file(name);
    std::ofstream(file.temporaryName()) << std::string(size, 'x');
    EXPECT_FALSE(file.commit()) << size;
  }
  EXPECT_EQ(textOf(name), "good");
}

TEST(WholeFile, NothingIsAddedToWhatIsWhole) {
  const TemporaryFolder folder;
  const std::string name = folder.file("face.ply");
  for (const size_t size : {0, 1, 4095, 4096, 200000}) {
    ASSERT_EQ(WholeFile::write(name, std::string(size, 'x')), "");
    EXPECT_EQ(textOf(name), std::string(size, 'x'));
  }
}

TEST(WholeFile, ASymbolicLinkStaysAndItsFileIsReplaced) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file.txt"), link = folder.file("link.txt");
  ASSERT_EQ(WholeFile::write(file, "old"), "");
  fs::create_symlink(file, link);
  ASSERT_EQ(WholeFile::write(link, "new"), "");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(textOf(file), "new");
}

TEST(WholeFile, PermissionsStay) {
  const TemporaryFolder folder;
  const std::string file = folder.file("file.txt");
  ASSERT_EQ(WholeFile::write(file, "old"), "");
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(file, own);
  ASSERT_EQ(WholeFile::write(file, "new"), "");
  EXPECT_EQ(fs::status(file).permissions(), own);
}
