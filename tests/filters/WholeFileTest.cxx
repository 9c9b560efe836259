#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "TemporaryFolder.h"
#include "WholeFile.h"

namespace {

namespace fs = std::filesystem;
using mien::WholeFile;

std::string textOf(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// As on a disk without space: the first bytes are written, the others are not.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
    signal_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }

 private:
  rlimit before_;
  void (*signal_)(int);
};

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
