#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "AnimateRun.h"
#include "PictureFile.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"

namespace {

TEST(AnimateCommand, WritesEveryFrame) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("frames");
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

TEST(AnimateCommand, ARangePastTheEndsOfTheFileIsRefused) {
  const TemporaryFolder folder;
  for (const char* range : {"290:310", "-5:2", "3,299:301"}) {
    const Outcome outcome = animate({demo, std::string("--frames=") + range, "-o", folder.file("a.pvd")});
    EXPECT_EQ(outcome.exitCode, 2) << range;
    EXPECT_NE(outcome.errors.find("run from 0 to 300"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(animate({demo, "--frames", "299:", "-o", folder.file("a.pvd")}).exitCode, 0);
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
  const FfmpegStandIn ffmpeg(folder, "last=${last#file:}\necho \"$@\" > \"$last\"\nwc -c >> \"$last\"\n");
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
      {{demo, "-o", frames, "--range", "3:4:5"}, 2},
      {{demo, "-o", frames, "--fps", "0"}, 2},
      {{demo, "-o", folder.file("no/film.ogv")}, 1},
      {{demo, "--contact-sheet", folder.file("no/sheet.png")}, 1},
      {{demo, "-o", folder.file("bad.fap") + "/x"}, 1},
      {{demo, "-o", folder.file("no/frames/")}, 1},
      {{demo, "-o", frames, "--frames", "900:"}, 2},
      {{demo, "-o", frames, "--frames", ""}, 2},
      {{demo, "-o", frames, "--frames", "1,2", "--fps", "50"}, 2},
      {{demo, "-o", frames, "--end", "100"}, 2},
      {{demo, "-o", folder.file("{frame}.png"), "--fps", "50"}, 2},
      {{demo, "-o", frames, "--zoom", "far"}, 2},
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

TEST(AnimateCommand, TablesExpressionsVisemesAndValuesReachEveryFrame) {
  const TemporaryFolder folder;
  const auto play = [&](const std::string& name, const std::vector<std::string>& options) {
    std::vector<std::string> all = {demo, "--frames", "40,60", "-o", folder.file(name + ".pvd")};
    all.insert(all.end(), options.begin(), options.end());
    EXPECT_EQ(animate(all).exitCode, 0) << name;
    return readTextFile(folder.file(name + "/" + name + "_0000.vts")) +
           readTextFile(folder.file(name + "/" + name + "_0001.vts"));
  };
  std::string table = readTextFile(MIEN_DATA_DIR "/animation/animation_table.json");
  writeTextFile(folder.file("same.json"), table);
  auto changed = nlohmann::json::parse(table);
  auto& faps = changed["faps"];
  for (size_t i = faps.size(); i-- > 0;)
    if (faps[i]["fap"] == 3) faps.erase(i);  // one that a table may lack
  writeTextFile(folder.file("changed.json"), changed.dump());
  const std::string plain = play("plain", {});
  EXPECT_TRUE(play("plain", {"--fat", folder.file("same.json")}) == plain);
  const std::vector<std::string> jaw = {"--set", "open_jaw=300"};
  EXPECT_TRUE(play("plain", {"--set", "open_jaw=300", "--fat", folder.file("changed.json")}) != play("plain", jaw));
  EXPECT_TRUE(play("plain", {"--fat", folder.file("changed.json")}) == plain) << "the demonstration has no jaw";
  for (const std::vector<std::string>& options :
       {jaw, {"--expression", "joy:0.5"}, {"--viseme", "U"}, {"--fdt", "joy"}})
    EXPECT_TRUE(play("plain", options) != plain) << options[1];
}

TEST(AnimateCommand, AStreamWritesTheSurfacesThatItsFileWrites) {
  const TemporaryFolder folder;
  const std::vector<std::string> bent = {"--fdt", "joy", "--resolution", "29x20"};
  std::vector<std::string> file = {"animate", demo, "--frames", "0:2", "-o", folder.file("file.pvd")};
  std::vector<std::string> stream = {"animate", "-", "-o", folder.file("stream.pvd")};
  file.insert(file.end(), bent.begin(), bent.end());
  stream.insert(stream.end(), bent.begin(), bent.end());
  ASSERT_EQ(runMien(file).exitCode, 0);
  Piped mien(stream);
  mien.send(demoLines(1, 8));
  ASSERT_EQ(mien.end(), 0);
  for (const char* const name : {"_0000.vts", "_0002.vts"})
    EXPECT_EQ(readTextFile(folder.file(std::string("stream/stream") + name)),
              readTextFile(folder.file(std::string("file/file") + name)));
}

TEST(AnimateCommand, AShorterSeriesLeavesNoSurfaceOfALongerOneAndNothingElseGoes) {
  const TemporaryFolder folder;
  const std::string film = folder.file("film.pvd");
  ASSERT_EQ(animate({demo, "--frames", "0:5", "-o", film}).exitCode, 0);
  ASSERT_EQ(animate({demo, "--frames", "0:5", "--series", "vtp", "-o", folder.file("b.pvd")}).exitCode, 0);
  for (const char* const name : {"film/film_4.vts", "film/film_0005.vts.txt", "film/other_0005.vts"})
    writeTextFile(folder.file(name), "mine");
  writeTextFile(folder.file("film/film_0001.vtp"), "of an earlier run as polygons");
  ASSERT_EQ(animate({demo, "--frames", "0:1", "-o", film}).exitCode, 0);
  EXPECT_EQ(entriesIn(folder.file("film")), 2 + 3);
}

TEST(AnimateCommand, FilesAreNamedByTheNumbersOfTheirFramesOnRequest) {
  const TemporaryFolder folder;
  ASSERT_EQ(animate({demo, "--frames", "9,5:6", "-o", folder.file("face-{frame}.vts")}).exitCode, 0);
  ASSERT_EQ(animate({demo, "--frames", "7", "-o", folder.file("face-{frame}.png")}).exitCode, 0);
  for (const char* const name : {"face-5.vts", "face-6.vts", "face-9.vts", "face-7.png"})
    EXPECT_TRUE(std::filesystem::exists(folder.file(name))) << name;
  EXPECT_EQ(entriesIn(folder.file("")), 4);
}

TEST(AnimateCommand, RepetitionsGoOnInTheTimeOfTheSurfacesToo) {
  const TemporaryFolder folder;
  ASSERT_EQ(animate({demo, "--frames", "0:1", "--loop", "2", "-o", folder.file("a.pvd")}).exitCode, 0);
  const std::vector<double> times = timesIn(folder.file("a.pvd"));
  ASSERT_EQ(times.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    vtkNew<vtkXMLStructuredGridReader> reader;
    reader->SetFileName(folder.file("a/a_000" + std::to_string(i) + ".vts").c_str());
    reader->Update();
    vtkDataArray* time = reader->GetOutput()->GetFieldData()->GetArray("TimeValue");
    ASSERT_NE(time, nullptr);
    EXPECT_NEAR(time->GetTuple1(0), times[i], 1e-9);
    EXPECT_NEAR(times[i], 0.04 * i, 1e-9);
  }
}

TEST(AnimateCommand, MessagesNameTheOptionThatWasGiven) {
  const TemporaryFolder folder;
  for (const char* const option : {"--range", "--frames"}) {
    const Outcome outcome = animate({demo, option, "900:", "-o", folder.file("a.pvd")});
    EXPECT_EQ(outcome.errors.rfind("mien: " + std::string(option) + " '900:' holds no frame", 0), 0u) << outcome.errors;
  }
}

TEST(AnimateCommand, ContactIsToldOnce) {
  const TemporaryFolder folder;
  const Outcome pressed = animate({demo, "--frames", "0:3", "--set", "51=300,52=300", "-o", folder.file("a.pvd")});
  EXPECT_EQ(pressed.exitCode, 0);
  EXPECT_NE(pressed.errors.find("pressed together in 4 of 4 frames"), std::string::npos) << pressed.errors;
  const Outcome open = animate({demo, "--frames", "0:0", "-o", folder.file("a.pvd")});
  EXPECT_EQ(open.errors, "");
  EXPECT_NE(open.output.find("1 surface in "), std::string::npos) << open.output;
}

TEST(AnimateCommand, MixedFramesMoveInPicturesToo) {
  const TemporaryFolder folder;
  const std::string frames = folder.file("f/");
  ASSERT_EQ(animate({demo, "--start", "1", "--end", "1.04", "--fps", "100", "-o", frames, "--set", "3=400"}).exitCode,
            0);
  ASSERT_EQ(entriesIn(frames), 5);
}

TEST(AnimateCommand, AColonInTheNameOfAFilmIsNoProtocol) {
  const TemporaryFolder folder;
  const FfmpegStandIn ffmpeg(folder, "echo \"$@\" > \"${last#file:}\"\ncat > /dev/null\n");
  ASSERT_EQ(animate({demo, "--frames", "0:1", "-o", folder.file("a:b.mp4")}).exitCode, 0);
  EXPECT_NE(readTextFile(folder.file("a:b.mp4")).find(" file:"), std::string::npos);
}

}  // namespace
