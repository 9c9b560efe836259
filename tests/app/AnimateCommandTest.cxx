#include "PictureFile.h"
#include "Program.h"

#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <gtest/gtest.h>
#include <signal.h>

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
  ASSERT_EQ(animate({demo, "--range", "10:12", "-o", folder.file("film.pvd")}).exitCode, 0);
  const std::string text = readTextFile(folder.file("film.pvd"));
  EXPECT_NE(text.find("timestep=\"0.4\" part=\"0\" file=\"film/film_0000.vtp\""), std::string::npos) << text;
  EXPECT_NE(text.find("timestep=\"0.48\" part=\"0\" file=\"film/film_0002.vtp\""), std::string::npos) << text;
  EXPECT_EQ(entriesIn(folder.file("film")), 3);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("film/film_0001.vtp").c_str());
  reader->Update();
  EXPECT_GT(reader->GetOutput()->GetNumberOfCells(), 28 * 19);
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

/// Seconds that a Theora film lasts: the number in its last Ogg page's granule position over the rate in its first header.
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
      {{demo, "-o", folder.file("film.avi")}, 2},
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
