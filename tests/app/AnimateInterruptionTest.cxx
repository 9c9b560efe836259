#include <stdlib.h>

#include "AnimateRun.h"
#include "PictureFile.h"

namespace {

/// Runs the program in the background and interrupts it once a file is there. @return its exit code
int interrupted(std::vector<std::string> words, const std::string& file) {
  words.insert(words.begin(), MIEN_PROGRAM);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return -1;
  EXPECT_TRUE(appears(file));
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AnimateCommand, AnInterruptionLeavesFinishedFilesOnlyAndNoneOfAnEarlierRun) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("frames");
  std::filesystem::create_directory(frames);
  writeTextFile(frames + "/" + frameName(299), "of an earlier run");
  EXPECT_EQ(interrupted({"animate", demo, "-o", frames, "--size", "64x64"}, frames + "/" + frameName(2)), 130);
  const long count = entriesIn(frames);
  EXPECT_GE(count, 3);
  EXPECT_LT(count, 301);
  for (int i = 0; i < count; ++i)
    ASSERT_EQ(readPicture(frames + "/" + frameName(i))->GetDimensions()[0], 64) << "hidden or unfinished files stayed";
}

TEST(AnimateCommand, AnInterruptedSeriesListsExactlyItsFiles) {
  const TemporaryFolder folder;
  const std::string film = folder.file("film.pvd");
  std::filesystem::create_directory(folder.file("film"));
  writeTextFile(folder.file("film/film_99999.vts"), "of an earlier run");
  EXPECT_EQ(interrupted({"animate", demo, "--loop", "100", "-o", film}, folder.file("film/film_0002.vts")), 130);
  const auto count = static_cast<long>(timesIn(film).size());
  EXPECT_GE(count, 3);
  EXPECT_LT(count, 30100);
  EXPECT_EQ(entriesIn(folder.file("film")), count);
  EXPECT_EQ(entriesIn(folder.file("")), 2);
}

/// Its temporary file appears when it begins.
bool filmBegins(const TemporaryFolder& folder, const std::string& film) {
  for (int i = 0; i < 3000; ++i, usleep(10000))
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("")))
      if (entry.path().filename().string().rfind("." + film + ".mien-", 0) == 0) return true;
  return false;
}

TEST(AnimateCommand, AnInterruptedFilmOfAFileLeavesNothing) {
  const TemporaryFolder folder;
  Piped mien({"animate", demo, "-o", folder.file("film.ogv"), "--size", "48x40", "--loop", "20"});
  ASSERT_TRUE(filmBegins(folder, "film"));
  mien.interrupt();
  EXPECT_EQ(mien.end(), 130);
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

TEST(AnimateCommand, AnInterruptedLiveFilmIsClosedWithWhatCame) {
  const TemporaryFolder folder;
  const std::string film = folder.file("live.ogv");
  Piped mien({"animate", "-", "-o", film, "--size", "48x40", "--resolution", "29x20"});
  mien.send(demoLines(1, 42));
  ASSERT_TRUE(filmBegins(folder, "live"));
  usleep(2000000);  // for the 20 frames; fewer are no failure
  mien.interrupt();
  EXPECT_EQ(mien.end(), 130);
  EXPECT_EQ(entriesIn(folder.file("")), 1);
  const std::string bytes = readTextFile(film);
  EXPECT_EQ(bytes.substr(0, 4), "OggS");
  EXPECT_GE(secondsOfFilm(bytes), 1.0 / 25.0);
  EXPECT_LE(secondsOfFilm(bytes), 20.0 / 25.0 + 1e-9);
}

TEST(AnimateCommand, AnInterruptedLiveFilmHoldsAllThatHadCome) {
  const TemporaryFolder folder;
  const std::string film = folder.file("live.ogv");
  Piped mien({"animate", "-", "-o", film, "--size", "480x400", "--resolution", "113x80"});
  mien.send(demoLines(1, 122));
  ASSERT_TRUE(filmBegins(folder, "live"));
  mien.interrupt();  // long before 60 frames of that size are drawn
  EXPECT_EQ(mien.end(), 130);
  EXPECT_NEAR(secondsOfFilm(readTextFile(film)), 60.0 / 25.0, 1e-9);
}

/// Standard error of a run as a terminal of its own shows it.
std::string onTerminal(std::vector<std::string> words) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) return "no terminal";
  words.insert(words.begin(), MIEN_PROGRAM);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 2, ptsname(terminal), O_WRONLY | O_NOCTTY, 0);
  pid_t child = 0;
  posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  std::string text;
  char part[4096];
  for (ssize_t count = 0; (count = read(terminal, part, sizeof part)) > 0;) text.append(part, count);
  waitpid(child, nullptr, 0);
  close(terminal);
  return text;
}

TEST(AnimateCommand, ProgressTellsTheTimeThatIsLeftOnceItIsKnown) {
  const TemporaryFolder folder;
  const std::string text = onTerminal({"animate", demo, "--loop", "3", "-o", folder.file("film.pvd")});
  EXPECT_NE(text.find("frame 0 of 903\r"), std::string::npos) << text;  // the line is replaced, not ended
  EXPECT_EQ(text.find("frame 0 of 903,"), std::string::npos) << "nobody knows yet";
  const size_t left = text.find(" left");
  ASSERT_NE(left, std::string::npos) << text;
  const size_t comma = text.rfind(", ", left);
  EXPECT_GE(std::stod(text.substr(comma + 2)), 1.0) << text;
}

}  // namespace
