#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "CsvRows.h"
#include "Program.h"
#include "ReferenceData.h"

namespace {

using nlohmann::json;

/// Three frames: the jaw opens, then the head turns too.
std::string writeAnimation(const TemporaryFolder& folder) {
  const std::string name = folder.file("three.fap");
  std::string text = "2.1 three 25 3\n";
  const double values[3][2] = {{100.0, 0.0}, {300.0, 0.0}, {300.0, 20000.0}};
  for (int i = 0; i < 3; ++i) {
    for (int fap = 1; fap <= 68; ++fap) text += fap == 3 || fap == 49 ? "1 " : "0 ";
    text +=
        "\n" + std::to_string(10 + i) + " " + std::to_string(values[i][0]) + " " + std::to_string(values[i][1]) + "\n";
  }
  writeTextFile(name, text);
  return name;
}

json report(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "vectors");
  arguments.push_back("--json");
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return outcome.exitCode == 0 ? json::parse(outcome.output) : json();
}

/// Rounding is written as 0.
double written(double component) {
  return std::abs(component) < 1e-9 ? 0.0 : component;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(VectorsCommand, TheFieldIsTheDifferenceOfTheTwoSurfaces) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& surface : std::vector<std::vector<std::string>>{
           {"surface", "--expression", "joy", "--precision", "double", "-o", folder.file("joy.csv")},
           {"surface", "--precision", "double", "-o", folder.file("neutral.csv")},
           {"vectors", "--expression", "joy", "-o", folder.file("field.csv")}})
    ASSERT_EQ(runMien(surface).exitCode, 0);
  // The surface's table has the rows on seams twice: points are found by where they start.
  const auto neutral = csvRows(folder.file("neutral.csv")), joy = csvRows(folder.file("joy.csv"));
  const auto place = [](const std::vector<std::string>& row) {
    return std::vector<double>{std::stod(row[3]), std::stod(row[4]), std::stod(row[5])};
  };
  std::multimap<std::vector<double>, std::vector<double>> ends;
  for (size_t i = 0; i < neutral.size(); ++i) {
    std::vector<double> start = place(neutral[i]), motion = place(joy[i]);
    for (int axis = 0; axis < 3; ++axis) motion[axis] = written(motion[axis] - start[axis]);
    for (double& coordinate : start) coordinate = written(coordinate);
    ends.emplace(start, motion);
  }
  const auto field = csvRows(folder.file("field.csv"));
  ASSERT_EQ(field.size(), 56u * 40u);
  for (const auto& row : field) {
    ASSERT_EQ(row.size(), 9u);
    const std::vector<double> start = {std::stod(row[2]), std::stod(row[3]), std::stod(row[4])};
    bool exact = false;
    const auto [first, last] = ends.equal_range(start);
    ASSERT_NE(first, last);
    for (auto end = first; end != last; ++end)
      exact = exact || end->second == std::vector<double>{std::stod(row[5]), std::stod(row[6]), std::stod(row[7])};
    EXPECT_TRUE(exact) << row[0] << " " << row[1];
    EXPECT_NEAR(std::stod(row[8]), std::hypot(std::stod(row[5]), std::stod(row[6]), std::stod(row[7])), 2e-9);
  }
}

TEST(VectorsCommand, NoMotionHasNoArrowsAndSaysSo) {
  const TemporaryFolder folder;
  const Outcome outcome = runMien({"vectors", "-o", folder.file("zero.svg")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("no motion"), std::string::npos);
  const std::string figure = readTextFile(folder.file("zero.svg"));
  EXPECT_NE(figure.find("No motion"), std::string::npos);
  EXPECT_EQ(count(figure, "<path"), 0);
  EXPECT_EQ(report({})["fields"][0]["arrows"], 0);
}

TEST(VectorsCommand, AgainstAnotherFrameThePreviousOneAndWithoutTheHead) {
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);
  const double first = report({"--fap", file, "--frame", "10"})["fields"][0]["largest_mm"];
  const double second = report({"--fap", file, "--frame", "11"})["fields"][0]["largest_mm"];
  const double previous = report({"--fap", file, "--frame", "11", "--against", "previous"})["fields"][0]["largest_mm"];
  const double frame = report({"--fap", file, "--frame", "11", "--against", "10"})["fields"][0]["largest_mm"];
  EXPECT_EQ(previous, frame);
  EXPECT_NEAR(previous, second - first, 0.05 * second);
  const double turned = report({"--fap", file, "--frame", "12", "--against", "11"})["fields"][0]["largest_mm"];
  EXPECT_GT(turned, 5.0);
  const std::vector<std::string> still = {"--fap", file, "--frame", "12", "--against", "11", "--remove-head-motion"};
  EXPECT_LT(report(still)["fields"][0]["largest_mm"], 1e-9);
  EXPECT_EQ(report(still)["fields"][0]["arrows"], 0);
  const std::vector<std::string> turnedBack = {"--fap", file, "--frame", "12", "--remove-head-motion"};
  EXPECT_NEAR(report(turnedBack)["fields"][0]["largest_mm"].get<double>(), second, 1e-9);
}

TEST(VectorsCommand, ASeriesSharesScaleAndRangeInOneFileOrInSeveral) {
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);
  const json about =
      report({"--fap", file, "--frames", "10,11", "--sample", "every:1", "-o", folder.file("all.svg"), "-o",
              folder.file("one-{frame}.svg"), "-o", folder.file("all.csv"), "-o", folder.file("one-{frame}.vtp")});
  ASSERT_EQ(about["fields"].size(), 2u);
  EXPECT_EQ(about["fields"][1]["frame"], 11.0);
  EXPECT_GE(about["range_mm"][1].get<double>(), about["fields"][1]["largest_mm"].get<double>());
  const std::string all = readTextFile(folder.file("all.svg"));
  EXPECT_NE(all.find("(b) frame 11"), std::string::npos);
  EXPECT_EQ(csvRows(folder.file("all.csv")).size(), 2u * 56u * 40u);
  EXPECT_EQ(csvRows(folder.file("all.csv"))[0].size(), 10u);
  for (const char* const name : {"one-10", "one-11"}) {
    const std::string one = readTextFile(folder.file(name + std::string(".svg")));
    EXPECT_NE(one.find("1 mm of arrow ="), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder.file(name + std::string(".vtp"))));
  }
  const auto key = [&](const std::string& figure) {
    const size_t at = figure.find("1 mm of arrow =");
    return figure.substr(at, figure.find('<', at) - at);
  };
  EXPECT_EQ(key(readTextFile(folder.file("one-10.svg"))), key(readTextFile(folder.file("one-11.svg"))));
}

TEST(VectorsCommand, TheSameCommandGivesTheSameBytes) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  std::vector<std::string> before;
  const TemporaryFolder folder;
  for (int run = 0; run < 2; ++run) {
    std::vector<std::string> arguments = {"vectors", "--expression", "surprise", "--view", "45"};
    for (const char* const ending : {"svg", "pdf", "png", "csv", "vtp"})
      arguments.insert(arguments.end(), {"-o", folder.file(std::string("a.") + ending)});
    ASSERT_EQ(runMien(arguments).exitCode, 0);
    std::vector<std::string> files;
    for (const char* const ending : {"svg", "pdf", "png", "csv", "vtp"})
      files.push_back(readTextFile(folder.file(std::string("a.") + ending)));
    for (size_t i = 0; i < before.size(); ++i) EXPECT_TRUE(files[i] == before[i]) << i;
    before = files;
  }
  unsetenv("SOURCE_DATE_EPOCH");
  EXPECT_EQ(before[0].find("<image"), std::string::npos);
  EXPECT_EQ(before[1].find("/Subtype /Image"), std::string::npos);
  EXPECT_NE(before[0].find("mien vectors"), std::string::npos);
  EXPECT_NE(before[0].find("mien_face_state"), std::string::npos);
}

TEST(VectorsCommand, AnotherSurfaceOfTheSameTopologyCanBeTheOrigin) {
  const TemporaryFolder folder;
  const double against = report({"--expression", "joy"})["fields"][0]["largest_mm"];
  for (const char* const ending : {"vts", "vtp", "ply", "obj"}) {
    const std::string neutral = folder.file(std::string("neutral.") + ending),
                      joy = folder.file(std::string("joy.") + ending);
    ASSERT_EQ(runMien({"surface", "-o", neutral}).exitCode, 0);
    ASSERT_EQ(runMien({"surface", "--expression", "joy", "-o", joy}).exitCode, 0);
    EXPECT_NEAR(report({"--expression", "joy", "--against", neutral})["fields"][0]["largest_mm"].get<double>(), against,
                1e-3)
        << ending;
    EXPECT_NEAR(
        report({joy, "--against", neutral, "-o", folder.file("a.svg")})["fields"][0]["largest_mm"].get<double>(),
        against, 1e-3)
        << ending;
    EXPECT_EQ(report({neutral, "--against", neutral})["fields"][0]["arrows"], 0) << ending;
  }
  ASSERT_EQ(runMien({"surface", "--resolution", "29x40", "-o", folder.file("other.vts")}).exitCode, 0);
  const Outcome other = runMien({"vectors", "--expression", "joy", "--against", folder.file("other.vts")});
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_NE(other.errors.find("other.vts"), std::string::npos);
  EXPECT_NE(other.errors.find("points"), std::string::npos);
}

TEST(VectorsCommand, CaptionsNameEveryPartOfTheFace) {
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder), figure = folder.file("a.svg");
  const auto words = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--width", "250", "-o", figure});
    report(options);
    return readTextFile(figure);
  };
  const std::string both = words({"--fap", file, "--frame", "11", "--set", "5=200", "--hidden", "--view", "45"});
  for (const char* const part : {"Frame 11 of three.fap, FAP 5 = 200 against the neutral face", "view: 45\u00b0",
                                 "vectors behind the face are drawn too", "mm apart"})
    EXPECT_NE(both.find(part), std::string::npos) << part;
  EXPECT_NE(words({"--fdt", "joy:0.5"}).find("deformation table joy at 0.5"), std::string::npos);
  EXPECT_NE(words({"--viseme", "A"}).find("viseme"), std::string::npos);
  EXPECT_GT(report({"--viseme", "A"})["fields"][0]["largest_mm"], 1.0) << "visemes are motion against the neutral face";
  EXPECT_NE(words({"--fap", file, "--frames", "10,11"}).find("Frames 10, 11 of three.fap against"), std::string::npos);
}

TEST(VectorsCommand, StandardInputIsReadOnce) {
  const Outcome outcome = runMien({"vectors", "--fap", "-", "--against", "previous"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.errors.find("--fap -"), std::string::npos);
  EXPECT_NE(outcome.errors.find("twice"), std::string::npos);
}

TEST(VectorsCommand, SurfaceFilesTakeNoOptionsOfAFace) {
  const TemporaryFolder folder;
  const std::string mesh = folder.file("a.ply");
  ASSERT_EQ(runMien({"surface", "-o", mesh}).exitCode, 0);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{"--fdt", "joy"},
                                                                                      {"--scheme", "tangent"},
                                                                                      {"-a", "2"},
                                                                                      {"--set", "3=5"},
                                                                                      {"--resolution", "29x40"},
                                                                                      {"--viseme", "A"},
                                                                                      {"--uniform-rows"}}) {
    std::vector<std::string> arguments = {"vectors", mesh, "--against", mesh};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Outcome outcome = runMien(arguments);
    EXPECT_EQ(outcome.exitCode, 2) << option[0];
    EXPECT_NE(outcome.errors.find("describes a face"), std::string::npos) << outcome.errors;
  }
}

TEST(VectorsCommand, AStillHeadStaysStillInScansWithoutItsMotion) {
  MIEN_REQUIRE_REFERENCE("heads");
  const std::string heads = referencePath("heads/");
  const std::vector<std::string> scans = {heads + "subject01_joy.ply", "--against", heads + "subject01_neutral.ply"};
  const json with = report(scans);
  std::vector<std::string> removed = scans;
  removed.push_back("--remove-head-motion");
  const json without = report(removed);
  EXPECT_NEAR(without["fields"][0]["mean_mm"].get<double>(), with["fields"][0]["mean_mm"].get<double>(), 0.01);
  EXPECT_NEAR(without["fields"][0]["largest_mm"].get<double>(), with["fields"][0]["largest_mm"].get<double>(), 0.01);
}

TEST(VectorsCommand, RegionsAndSamplingChooseWhatIsWritten) {
  const TemporaryFolder folder;
  const int all = report({"--expression", "joy"})["fields"][0]["vectors"];
  const int half = report({"--expression", "joy", "--sample", "every:2"})["fields"][0]["vectors"];
  EXPECT_EQ(all, 2240);
  EXPECT_EQ(half, 1120);
  for (const char* const region : {"mouth", "eyes", "brows", "nose", "cheeks", "chin", "P7", "-20,-60,20,-30"}) {
    const json about = report({"--expression", "joy", "--region", region});
    EXPECT_GT(about["fields"][0]["vectors"], 5) << region;
    EXPECT_LT(about["fields"][0]["vectors"], 500) << region;
  }
  EXPECT_GT(report({"--expression", "joy", "--sample", "every:1", "--hidden"})["fields"][0]["arrows"],
            report({"--expression", "joy", "--sample", "every:1"})["fields"][0]["arrows"]);
}

TEST(VectorsCommand, WrongValuesSayWhatIsAllowed) {
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--fap", file, "--frames", "10,99"},
                                             {"--fap", file, "--frame", "99"},
                                             {"--fap", file, "--against", "99"},
                                             {"--fap", file, "--frame", "10", "--against", "previous"},
                                             {"--fap", file, "--frame", "10", "--frames", "11"},
                                             {"--frames", "10"},
                                             {"--against", "previous"},
                                             {"--against", "mesh.gif"},
                                             {"--sample", "even:0"},
                                             {"--scale", "0"},
                                             {"--scale", "-1"},
                                             {"--range", "5:1"},
                                             {"--range", "5"},
                                             {"--colormap", "jet"},
                                             {"--color", "red"},
                                             {"--length", "long"},
                                             {"--font", "No Such Font"},
                                             {"--width", "10"},
                                             {"--view", "inside"},
                                             {"--region", "P9"},
                                             {"--region", "900,900,910,910"},
                                             {"--theme", "pink"},
                                             {"--columns", "0"},
                                             {"-o", "a.gif"},
                                             {"-o", folder.file("a-{frame}.svg")},
                                             {"--fap", file, "--frames", "10,11", "-o", folder.file("a.vtp")},
                                             {"face.ply"}}) {
    std::vector<std::string> arguments = {"vectors"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runMien(arguments);
    EXPECT_EQ(outcome.exitCode, 2) << options[0] << " " << options.back() << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("mien: ", 0), 0u) << options[0];
  }
  EXPECT_EQ(runMien({"vectors", "--against", folder.file("none.ply")}).exitCode, 1);
  EXPECT_EQ(entriesIn(folder.file("")), 1);  // the animation only
}

TEST(VectorsCommand, NoMotionTowardsTheViewerIsSaid) {
  const TemporaryFolder folder;
  const std::string figure = folder.file("v.svg");
  const Outcome outcome = runMien({"vectors", "--expression", "surprise", "--color", "towards", "-o", figure});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("no motion towards the viewer"), std::string::npos) << outcome.output;
  EXPECT_NE(readTextFile(figure).find("No motion towards the viewer"), std::string::npos);
}

}  // namespace
