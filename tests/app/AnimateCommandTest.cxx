#include <gtest/gtest.h>
#include <signal.h>

#include <array>
#include <sstream>

#include "PictureFile.h"
#include "Program.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"

namespace {

const std::string demo = std::string(MIEN_DATA_DIR) + "/animation/demo.fap";
const std::vector<std::string> small = {"--size", "48x40", "--resolution", "29x20"};

Outcome animate(std::vector<std::string> options) {
  options.insert(options.begin(), "animate");
  options.insert(options.end(), small.begin(), small.end());
  return runMien(options);
}

std::string frameName(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%04d.png", index);
  return name;
}

TEST(AnimateCommand, WritesEveryFrame) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("a/frames");
  const Outcome outcome = animate({demo, "--range", "0:9", "-o", frames});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(entriesIn(frames), 10);
  for (int i = 0; i < 10; ++i) {
    const auto picture = readPicture(frames + "/" + frameName(i));
    ASSERT_EQ(picture->GetDimensions()[0], 48);
    ASSERT_EQ(picture->GetDimensions()[1], 40);
    EXPECT_GT(shareUnlikeCorner(picture), 0.2);
  }
}

TEST(AnimateCommand, AShorterRunLeavesNoFrameOfALongerOne) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("frames/");
  ASSERT_EQ(animate({demo, "--range", "0:4", "-o", frames}).exitCode, 0);
  writeTextFile(frames + "notes.txt", "mine");
  ASSERT_EQ(animate({demo, "--range", "0:2", "-o", frames}).exitCode, 0);
  EXPECT_EQ(entriesIn(frames), 4);
  EXPECT_FALSE(std::filesystem::exists(frames + frameName(3)));
}

TEST(AnimateCommand, ContactSheetShowsFramesSideBySide) {
  const TemporaryFolder folder;
  const std::string sheet = folder.file("sheet.png");
  ASSERT_EQ(animate({"--contact-sheet", sheet, "--range", "0:60"}).exitCode, 0);
  const auto picture = readPicture(sheet);
  EXPECT_EQ(picture->GetDimensions()[0], 10 + 6 * (48 + 10));
  EXPECT_EQ(picture->GetDimensions()[1], 10 + 4 * (40 + 22 + 10));
  EXPECT_GT(shareUnlikeCorner(picture), 0.15);
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

TEST(AnimateCommand, SurfaceSeriesNamesItsFilesAndTimes) {
  const TemporaryFolder folder;
  ASSERT_EQ(animate({demo, "--range", "10:12", "--series", "vtp", "-o", folder.file("film.pvd")}).exitCode, 0);
  const std::string text = readTextFile(folder.file("film.pvd"));
  EXPECT_NE(text.find("timestep=\"0.4\" part=\"0\" file=\"film/film_0000.vtp\""), std::string::npos) << text;
  EXPECT_NE(text.find("timestep=\"0.48\" part=\"0\" file=\"film/film_0002.vtp\""), std::string::npos) << text;
  EXPECT_EQ(entriesIn(folder.file("film")), 3);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("film/film_0001.vtp").c_str());
  reader->Update();
  EXPECT_GT(reader->GetOutput()->GetNumberOfCells(), 28 * 19);
}

std::vector<double> timesIn(const std::string& series) {
  const std::string text = readTextFile(series);
  std::vector<double> times;
  for (size_t at = 0; (at = text.find("timestep=\"", at)) != std::string::npos; ++at)
    times.push_back(std::stod(text.substr(at + 10)));
  return times;
}

TEST(AnimateCommand, SeriesAreGridsUnlessPolygonsAreAskedFor) {
  const TemporaryFolder folder;
  ASSERT_EQ(animate({demo, "--frames", "0:1", "-o", folder.file("a.pvd")}).exitCode, 0);
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(folder.file("a/a_0001.vts").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 29 * 21);
  EXPECT_EQ(animate({demo, "--series", "ply", "-o", folder.file("a.pvd")}).exitCode, 2);
}

std::array<double, 3> pointOf(const std::string& grid) {
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(grid.c_str());
  reader->Update();
  std::array<double, 3> point;
  reader->GetOutput()->GetPoint(7 * 21 + 5, point.data());
  return point;
}

TEST(AnimateCommand, SecondsChooseFramesAndRepetitionsFollow) {
  const TemporaryFolder folder;
  const std::string film = folder.file("a.pvd");
  ASSERT_EQ(animate({demo, "--start", "1", "--end", "1.1", "--loop", "2", "-o", film}).exitCode, 0);
  const std::vector<double> wanted = {1.0, 1.04, 1.08, 1.12, 1.16, 1.2};
  const std::vector<double> times = timesIn(film);
  ASSERT_EQ(times.size(), wanted.size());
  for (size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], wanted[i], 1e-9);
  EXPECT_EQ(pointOf(folder.file("a/a_0001.vts")), pointOf(folder.file("a/a_0004.vts")));
  ASSERT_EQ(animate({demo, "--start", "1.01", "--end", "1.03", "--fps", "100", "-o", folder.file("b.pvd")}).exitCode,
            0);
  EXPECT_EQ(timesIn(folder.file("b.pvd")).size(), 3u);
  for (const std::vector<std::string>& options : {std::vector<std::string>{"--start", "20"},
                                                  {"--start", "1.01", "--end", "1.03"},
                                                  {"--loop", "0"},
                                                  {"--end", "-1"},
                                                  {"--start", "x"}}) {
    std::vector<std::string> all = {demo, "-o", film};
    all.insert(all.end(), options.begin(), options.end());
    EXPECT_EQ(animate(all).exitCode, 2) << options[0] << " " << options[1];
  }
}

/// Puts a stand-in for ffmpeg in front of the search path, which notes its arguments and how many bytes it was given.
class FfmpegStandIn {
 public:
  FfmpegStandIn(const TemporaryFolder& folder, const std::string& script) : path_(getenv("PATH")) {
    std::filesystem::create_directory(folder.file("bin"));
    writeTextFile(folder.file("bin/ffmpeg"),
                  "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\nfor last; do :; done\n" + script);
    std::filesystem::permissions(folder.file("bin/ffmpeg"), std::filesystem::perms::owner_all);
    setenv("PATH", (folder.file("bin") + ":" + path_).c_str(), 1);
  }
  ~FfmpegStandIn() { setenv("PATH", path_.c_str(), 1); }

 private:
  std::string path_;
};

TEST(AnimateCommand, FilmsOfOtherKindsGoThroughFfmpeg) {
  const TemporaryFolder folder;
  const FfmpegStandIn ffmpeg(folder, "echo \"$@\" > \"$last\"\nwc -c >> \"$last\"\n");
  for (const char* ending : {"mp4", "webm", "gif"}) {
    const std::string film = folder.file(std::string("film.") + ending);
    const Outcome outcome = animate({demo, "--frames", "0:4", "-o", film});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const std::string text = readTextFile(film);
    EXPECT_NE(text.find("-s 48x40 -r 25 -i -"), std::string::npos) << text;
    EXPECT_NE(text.find(std::to_string(5 * 48 * 40 * 3)), std::string::npos) << text;
  }
  EXPECT_EQ(entriesIn(folder.file("")), 4);
}

TEST(AnimateCommand, WhatFfmpegSaysIsTold) {
  const TemporaryFolder folder;
  const FfmpegStandIn ffmpeg(folder, "cat > /dev/null\necho 'no such codec' >&2\nexit 1\n");
  const Outcome outcome = animate({demo, "--frames", "0:1", "-o", folder.file("film.mp4")});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.errors.find("no such codec"), std::string::npos) << outcome.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

TEST(AnimateCommand, WithoutFfmpegTheSentenceSaysWhatToDo) {
  const TemporaryFolder folder;
  const std::string path = getenv("PATH");
  setenv("PATH", folder.file("").c_str(), 1);
  const Outcome outcome = animate({demo, "--frames", "0:1", "-o", folder.file("film.webm")});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.errors.find(".webm needs ffmpeg, which is not installed"), std::string::npos) << outcome.errors;
}

/// A command with a pipe as its standard input.
class Piped {
 public:
  explicit Piped(std::vector<std::string> words) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return;
    words.insert(words.begin(), MIEN_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, ends[0], 0);
    posix_spawn(&child_, argv[0], &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    close(ends[0]);
    input_ = ends[1];
  }
  void send(const std::string& text) {
    ASSERT_EQ(write(input_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void interrupt() { kill(child_, SIGINT); }
  int end() {
    close(input_);
    int status = 0;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = 0;
  int input_ = -1;
};

/// Lines of the demonstration: two of header, two per frame.
std::string demoLines(int first, int last) {
  std::istringstream lines(readTextFile(demo));
  std::string text, line;
  for (int number = 1; std::getline(lines, line); ++number)
    if (number >= first && number <= last) text += line + "\n";
  return text;
}

bool appears(const std::string& file) {
  for (int i = 0; i < 3000 && !std::filesystem::exists(file); ++i) usleep(10000);
  return std::filesystem::exists(file);
}

TEST(AnimateCommand, AStreamIsShownAsItComes) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("frames");
  Piped mien({"animate", "-", "-o", frames, "--size", "48x40", "--resolution", "29x20"});
  mien.send(demoLines(1, 8));
  ASSERT_TRUE(appears(frames + "/" + frameName(2))) << "while the stream is still open";
  EXPECT_FALSE(std::filesystem::exists(frames + "/" + frameName(4)));
  mien.send(demoLines(9, 12));
  ASSERT_TRUE(appears(frames + "/" + frameName(4)));
  EXPECT_EQ(mien.end(), 0);
}

TEST(AnimateCommand, AStreamThatIsWrongOrStoppedLeavesItsFrames) {
  const TemporaryFolder folder;
  Piped wrong({"animate", "-", "-o", folder.file("wrong.pvd"), "--resolution", "29x20"});
  wrong.send(demoLines(1, 8) + "0 0 1\n");
  EXPECT_EQ(wrong.end(), 1);
  EXPECT_EQ(timesIn(folder.file("wrong.pvd")).size(), 3u);
  Piped stopped({"animate", "-", "-o", folder.file("stopped.pvd"), "--resolution", "29x20"});
  stopped.send(demoLines(1, 8));
  ASSERT_TRUE(appears(folder.file("stopped/stopped_0002.vts")));
  stopped.interrupt();
  EXPECT_EQ(stopped.end(), 130);
  EXPECT_EQ(timesIn(folder.file("stopped.pvd")).size(), 3u);
  Piped empty({"animate", "-", "-o", folder.file("empty.pvd")});
  EXPECT_EQ(empty.end(), 1);
  EXPECT_EQ(runMien({"animate", "-", "--fps", "3", "-o", folder.file("a.pvd")}).exitCode, 2);
}

TEST(AnimateCommand, AnotherRateMixesFrames) {
  const TemporaryFolder folder;
  ASSERT_EQ(animate({demo, "--range", "10:20", "--fps", "100", "-o", folder.file("film.pvd")}).exitCode, 0);
  EXPECT_EQ(entriesIn(folder.file("film")), 41);
  ASSERT_EQ(runMien({"curves", "--fap", demo, "--time", "0.41", "-o", folder.file("a.csv")}).exitCode, 0);
  ASSERT_EQ(runMien({"curves", "--fap", demo, "--index", "10", "-o", folder.file("b.csv")}).exitCode, 0);
  EXPECT_EQ(readTextFile(folder.file("a.csv")), readTextFile(folder.file("b.csv")));  // --time gives the frame before
}

TEST(AnimateCommand, WritesAFilm) {
  const TemporaryFolder folder;
  const Outcome outcome = animate({demo, "--range", "0:5", "-o", folder.file("film.ogv")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(readTextFile(folder.file("film.ogv")).substr(0, 4), "OggS");
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

/// Seconds that a Theora film lasts: the number in its last Ogg page's granule position over the rate in its first
/// header.
double secondsOfFilm(const std::string& bytes) {
  const auto byte = [&](size_t at) { return static_cast<unsigned long>(static_cast<unsigned char>(bytes.at(at))); };
  const size_t header = bytes.find("\x80theora");
  const auto number = [&](size_t at) { return byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3); };
  const double rate = static_cast<double>(number(header + 22)) / static_cast<double>(number(header + 26));
  const unsigned long shift = (byte(header + 40) & 3) << 3 | byte(header + 41) >> 5;
  const size_t last = bytes.rfind("OggS");
  unsigned long position = 0;
  for (size_t i = 0; i < 8; ++i) position |= byte(last + 6 + i) << (8 * i);
  return static_cast<double>((position >> shift) + (position & ((1ul << shift) - 1))) / rate;
}

TEST(AnimateCommand, AFilmLastsAsLongAsItsFramesAtRatesThatAreNotWhole) {
  const TemporaryFolder folder;
  for (const double rate : {0.5, 2.5, 7.3, 29.97}) {
    std::string text = "2.1 film " + std::to_string(rate) + " 6\n";
    for (int frame = 0; frame < 6; ++frame) {
      for (int fap = 1; fap <= 68; ++fap) text += fap == 53 ? "1 " : "0 ";
      text += "\n" + std::to_string(frame) + " " + std::to_string(50 * frame) + "\n";
    }
    writeTextFile(folder.file("a.fap"), text);
    ASSERT_EQ(animate({folder.file("a.fap"), "-o", folder.file("a.ogv")}).exitCode, 0);
    EXPECT_NEAR(secondsOfFilm(readTextFile(folder.file("a.ogv"))), 6.0 / rate, 0.51 / std::max(rate, 1.0)) << rate;
  }
}

TEST(AnimateCommand, FAPsWithoutGeometryAreReportedOnce) {
  const TemporaryFolder folder;
  std::string mask;
  for (int fap = 1; fap <= 68; ++fap) mask += fap == 23 ? "1 " : "0 ";
  writeTextFile(folder.file("eyes.fap"), "2.1 eyes 25 2\n" + mask + "\n0 100\n" + mask + "\n1 200\n");
  const Outcome outcome = animate({folder.file("eyes.fap"), "-o", folder.file("eyes.pvd")});
  EXPECT_EQ(outcome.exitCode, 0);
  const size_t first = outcome.errors.find("23 yaw_l_eyeball");
  EXPECT_NE(first, std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.errors.find("23 yaw_l_eyeball", first + 1), std::string::npos) << outcome.errors;
}

TEST(AnimateCommand, WrongValuesAndFilesAreRefused) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("bad.fap"), "2.1 bad 25 1\n0 1\n0\n");
  const std::string frames = folder.file("frames");
  const std::vector<std::pair<std::vector<std::string>, int>> cases = {
      {{demo}, 2},
      {{demo, "-o", folder.file("film.xyz")}, 2},
      {{demo, "-o", frames, "--range", "900:"}, 2},
      {{demo, "-o", frames, "--range", "3"}, 2},
      {{demo, "-o", frames, "--fps", "0"}, 2},
      {{demo, "-o", folder.file("no/film.ogv")}, 1},
      {{demo, "--contact-sheet", folder.file("no/sheet.png")}, 1},
      {{demo, "-o", folder.file("bad.fap") + "/x"}, 1},
      {{folder.file("bad.fap"), "-o", frames}, 1},
      {{folder.file("none.fap"), "-o", frames}, 1},
  };
  for (const auto& [options, code] : cases) {
    const Outcome outcome = animate(options);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("mien: ", 0), 0u) << outcome.errors;
  }
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

/// Runs the program in the background and interrupts it once it has begun to write.
TEST(AnimateCommand, AnInterruptionLeavesFinishedFilesOnly) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("frames");
  std::vector<std::string> words = {MIEN_PROGRAM, "animate", demo, "-o", frames, "--size", "64x64"};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  ASSERT_EQ(posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ), 0);
  for (int i = 0; i < 3000 && !std::filesystem::exists(frames + "/" + frameName(2)); ++i) usleep(10000);
  kill(child, SIGINT);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 130);
  const long count = entriesIn(frames);
  EXPECT_GE(count, 3);
  EXPECT_LT(count, 301);
  for (int i = 0; i < count; ++i)
    ASSERT_EQ(readPicture(frames + "/" + frameName(i))->GetDimensions()[0], 64) << "hidden or unfinished files stayed";
}

}  // namespace
