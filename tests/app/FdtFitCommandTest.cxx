#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "CommaText.h"
#include "NamedTables.h"
#include "Program.h"
#include "SampleRecording.h"
#include "TableFiles.h"

using nlohmann::json;
using Axes = SampleRecording::Axes;

namespace {

const SampleRecording& sample() {
  static const SampleRecording recording(*mien::namedTable("joy"));
  return recording;
}

/// Fits a recording with these options; the table, and what was said.
struct Fit {
  TemporaryFolder folder;
  Outcome outcome;

  explicit Fit(const std::string& text, std::vector<std::string> options = {}) {
    writeTextFile(folder.file("r.csv"), text);
    options.insert(options.begin(), {"fdt", "fit", folder.file("r.csv"), "-o", folder.file("t.csv"), "--json"});
    outcome = runMien(options);
  }
  mien::DeformationTable table() const { return tableFrom(folder.file("t.csv")); }
  bool wrote() const { return entriesIn(folder.file("")) == 2; }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos) << from;
  return text.replace(text.find(from), from.size(), to);
}

std::string negated(const std::string& number) {
  return number[0] == '-' ? number.substr(1) : "-" + number;
}

std::string withoutRegion(const std::string& text, int region, int keep) {
  std::istringstream lines(text);
  std::string line, result;
  while (std::getline(lines, line)) {
    bool dropped = false;
    for (int i = keep; !sample().markerIn(region, i).empty(); ++i)
      dropped = dropped || line.rfind(sample().markerIn(region, i) + ",", 0) == 0;
    if (!dropped) result += line + "\n";
  }
  return result;
}

}  // namespace

TEST(FdtFitCommand, FindsTheTableThatMovedTheMarkers) {
  const Fit fit(sample().recording());
  ASSERT_EQ(fit.outcome.exitCode, 0) << fit.outcome.errors;
  EXPECT_EQ(fit.outcome.errors, "");
  EXPECT_LT(tableDifference(fit.table(), *mien::namedTable("joy")), 1e-9);
  const json about = json::parse(fit.outcome.output);
  EXPECT_LT(about["rms"], 1e-12);
  ASSERT_EQ(about["regions"].size(), 16u);
  int points = 0;
  for (const json& region : about["regions"]) {
    EXPECT_EQ(region["a"].size(), 6u);
    EXPECT_EQ(region["b"].size(), 6u);
    EXPECT_TRUE(region["rms"].is_number());
    points += region["points"].get<int>();
    const auto& map = mien::namedTable("joy")->maps[region["region"].get<int>() - 1];
    EXPECT_NEAR(region["b"][4].get<double>(), map.coefficients(1, 4), 1e-9);
  }
  EXPECT_EQ(points, static_cast<int>(sample().size()) - 2);
}

TEST(FdtFitCommand, PicturesAndTwoFilesGiveTheSameTable) {
  const Fit pixels(sample().recording(Axes::Pixels), {"--y-down"});
  ASSERT_EQ(pixels.outcome.exitCode, 0) << pixels.outcome.errors;
  EXPECT_LT(tableDifference(pixels.table(), *mien::namedTable("joy")), 1e-9);
  for (const Axes axes : {Axes::Millimetres, Axes::Pixels}) {
    const TemporaryFolder folder;
    writeTextFile(folder.file("a.csv"), sample().state(false, axes));
    writeTextFile(folder.file("b.csv"), sample().state(true, axes));
    std::vector<std::string> words = {"fdt",          "fit",
                                      "--neutral",    folder.file("a.csv"),
                                      "--expression", folder.file("b.csv"),
                                      "-o",           folder.file("t.csv")};
    if (axes == Axes::Pixels) words.push_back("--y-down");
    const Outcome outcome = runMien(words);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_LT(tableDifference(tableFrom(folder.file("t.csv")), *mien::namedTable("joy")), 1e-9);
  }
}

TEST(FdtFitCommand, AChinAboveTheEyesIsRefusedWithAHint) {
  const Fit fit(sample().recording(Axes::Pixels));
  EXPECT_EQ(fit.outcome.exitCode, 1);
  EXPECT_NE(fit.outcome.errors.find("--y-down"), std::string::npos) << fit.outcome.errors;
  EXPECT_FALSE(fit.wrote());
}

TEST(FdtFitCommand, PupilsHaveNamesOrPlaces) {
  const std::string text = replaced(replaced(sample().recording(), "pupil_left", "L"), "pupil_right", "R");
  const Fit missing(text);
  EXPECT_EQ(missing.outcome.exitCode, 1);
  EXPECT_NE(missing.outcome.errors.find("pupil_left is missing"), std::string::npos) << missing.outcome.errors;
  const Fit named(text, {"--pupils", "L,R"});
  ASSERT_EQ(named.outcome.exitCode, 0) << named.outcome.errors;
  const auto places = [](bool after) {
    return (SampleRecording::cells({1.0, 0.0}, Axes::Millimetres, after) +
            SampleRecording::cells({-1.0, 0.0}, Axes::Millimetres, after))
        .substr(1);
  };
  const Fit placed(sample().recording(), {"--pupils", places(false), "--expression-pupils", places(true)});
  ASSERT_EQ(placed.outcome.exitCode, 0) << placed.outcome.errors;
  for (const Fit* fit : {&named, &placed}) EXPECT_LT(tableDifference(fit->table(), *mien::namedTable("joy")), 1e-9);
  EXPECT_EQ(Fit(text, {"--pupils", "L"}).outcome.exitCode, 2);
  EXPECT_EQ(Fit(text, {"--pupils", "1,2,3,x"}).outcome.exitCode, 2);
}

TEST(FdtFitCommand, AMistakenMarkerIsToldWithItsLineAndFitted) {
  const TemporaryFolder folder;
  const SampleRecording joy(*mien::namedTable("joy"));
  std::string text = joy.recording();
  const std::string name = joy.markerIn(10, 3);
  const std::size_t begin = text.find("\n" + name + ",") + 1, end = text.find('\n', begin);
  std::string row = text.substr(begin, end - begin);
  const std::size_t depth = row.rfind(','), y = row.rfind(',', depth - 1);
  row.replace(y + 1, depth - y - 1, std::to_string(std::stod(row.substr(y + 1)) + 33.0));
  text.replace(begin, end - begin, row);
  writeTextFile(folder.file("r.csv"), text);
  const Outcome outcome = runMien({"fdt", "fit", folder.file("r.csv"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const std::string line = std::to_string(1 + std::count(text.begin(), text.begin() + begin, '\n'));
  EXPECT_NE(outcome.errors.find(":" + line + ": marker " + name + " moves "), std::string::npos) << outcome.errors;
  EXPECT_EQ(nlohmann::json::parse(outcome.output)["suspects"], std::vector<std::string>{name});
}

TEST(FdtFitCommand, SparseRegionsAreNamedAndStrictRefusesThem) {
  const std::string text = withoutRegion(sample().recording(), 9, 4);
  const Fit fit(text);
  ASSERT_EQ(fit.outcome.exitCode, 0) << fit.outcome.errors;
  EXPECT_NE(fit.outcome.errors.find("r.csv: region 9 has fewer than 6 independent points"), std::string::npos)
      << fit.outcome.errors;
  EXPECT_NE(json::parse(fit.outcome.output)["warning"].get<std::string>().find("region 9"), std::string::npos);
  const Fit strict(text, {"--strict"});
  EXPECT_EQ(strict.outcome.exitCode, 1);
  EXPECT_FALSE(strict.wrote());
}

TEST(FdtFitCommand, RegionsWithoutMarkersStayStillWithAWarningAndStrictRefusesThem) {
  const std::string text = withoutRegion(sample().recording(), 16, 0);
  const Fit fit(text);
  ASSERT_EQ(fit.outcome.exitCode, 0) << fit.outcome.errors;
  EXPECT_NE(fit.outcome.errors.find("r.csv: region 16 has no point and will not move"), std::string::npos)
      << fit.outcome.errors;
  const mien::DeformationTable table = fit.table();
  EXPECT_EQ(table.maps[15].coefficients, mien::QuadraticMap::identity());
  for (int i = 0; i < 15; ++i)
    EXPECT_LT((table.maps[i].coefficients - mien::namedTable("joy")->maps[i].coefficients).norm(), 1e-8) << i + 1;
  const Fit strict(text, {"--strict"});
  EXPECT_EQ(strict.outcome.exitCode, 1);
  EXPECT_NE(strict.outcome.errors.find("no point lies in region 16"), std::string::npos) << strict.outcome.errors;
  EXPECT_FALSE(strict.wrote());
}

TEST(FdtFitCommand, MirroredPicturesGiveTheTableOfTheUprightOnes) {
  std::istringstream lines(sample().recording());
  std::string line, mirrored;
  for (bool header = true; std::getline(lines, line); header = false) {
    const std::vector<std::string> cells = mien::splitAtCommas(line);
    for (std::size_t i = 0; i < cells.size(); ++i)
      mirrored += (i ? "," : "") + (!header && (i == 1 || i == 4) ? negated(cells[i]) : cells[i]);
    mirrored += "\n";
  }
  const Fit fit(mirrored, {"--mirrored"});
  ASSERT_EQ(fit.outcome.exitCode, 0) << fit.outcome.errors;
  EXPECT_LT(tableDifference(fit.table(), *mien::namedTable("joy")), 1e-9);
}

TEST(FdtFitCommand, BlankCellsAreMissingMarkersAndRegionsCanBeGiven) {
  std::istringstream lines(sample().recording());
  std::string line, text;
  const std::string unseen = sample().markerIn(10), moved = sample().markerIn(11);
  while (std::getline(lines, line)) {
    const std::string name = line.substr(0, line.find(','));
    if (name == unseen) line = name + ",,,,,,";
    text += line + (name == "marker" ? ",region" : name == moved ? ",12" : ",") + "\n";
  }
  const json about = json::parse(Fit(text).outcome.output),
             before = json::parse(Fit(sample().recording()).outcome.output);
  EXPECT_EQ(about["missing"], json::array({unseen}));
  const auto points = [](const json& fit, int region) { return fit["regions"][region - 1]["points"].get<int>(); };
  EXPECT_EQ(points(about, 10), points(before, 10) - 1);
  EXPECT_EQ(points(about, 11), points(before, 11) - 1);
  EXPECT_EQ(points(about, 12), points(before, 12) + 1);
}

TEST(FdtFitCommand, ErrorsNameFileRowAndWhatToDo) {
  const std::string good = sample().recording();
  const auto expect = [](const std::string& text, const std::string& part) {
    const Fit fit(text);
    EXPECT_EQ(fit.outcome.exitCode, 1);
    EXPECT_NE(fit.outcome.errors.find(part), std::string::npos) << fit.outcome.errors;
    EXPECT_EQ(std::count(fit.outcome.errors.begin(), fit.outcome.errors.end(), '\n'), 1) << fit.outcome.errors;
    EXPECT_FALSE(fit.wrote());
  };
  expect(replaced(good, "neutral_x", "n_x"), "r.csv:1: the header must name");
  expect(replaced(good, "\nm4,", "\nm4,nan,"), "r.csv:6: ");
  expect(replaced(good, "\nm4,", "\nm4,1,1,1,1,1,1\nm5,1,1,1,1,1,x\nm5,"), "r.csv:7: m5: 'x' in column expression_z");
  expect("", "r.csv:1: ");
  std::string semicolons = good;
  std::replace(semicolons.begin(), semicolons.end(), ',', ';');
  expect(semicolons, "separated by semicolons");
  EXPECT_EQ(runMien({"fdt", "fit"}).exitCode, 2);
  EXPECT_EQ(runMien({"fdt", "fit", "a.csv", "--neutral", "b.csv"}).exitCode, 2);
  EXPECT_EQ(runMien({"fdt", "fit", "/nowhere.csv"}).exitCode, 1);
  EXPECT_EQ(runMien({"fdt", "fit", "a.csv", "-o", "a.txt"}).exitCode, 2);
  EXPECT_EQ(runMien({"fdt"}).exitCode, 2);
  EXPECT_EQ(runMien({"fdt", "fits"}).exitCode, 2);
}

TEST(FdtFitCommand, SurfacesOfEqualTopologyAreFitted) {
  const TemporaryFolder folder;
  const std::string before = folder.file("a.vts"), after = folder.file("b.vts"), coarse = folder.file("c.vts");
  ASSERT_EQ(runMien({"surface", "-o", before}).exitCode, 0);
  ASSERT_EQ(runMien({"surface", "--expression", "joy", "-o", after}).exitCode, 0);
  ASSERT_EQ(runMien({"surface", "--resolution", "40x40", "-o", coarse}).exitCode, 0);
  const Outcome outcome = runMien({"fdt", "fit", "--neutral", before, "--expression", after, "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const json about = json::parse(outcome.output);
  EXPECT_LT(about["rms"], 0.03);
  EXPECT_GT(about["rms"], 0.0001);
  const Outcome other = runMien({"fdt", "fit", "--neutral", before, "--expression", coarse});
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_NE(other.errors.find("the same points before and after"), std::string::npos) << other.errors;
}
