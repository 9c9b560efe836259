#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Program.h"
#include "ReferenceData.h"

namespace {

using nlohmann::json;

json sweepOf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"sweep", "--json", "--resolution", "29x40"});
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");  // no progress where there is no terminal
  return json::parse(outcome.output, nullptr, false);
}

TEST(SweepCommand, RangesAndListsAreValuesOfA) {
  const json list = sweepOf({"--a", "2,0.5,1"})["samples"], range = sweepOf({"-a", "0.1:10:5log"})["samples"];
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[1]["a"], 0.5);
  ASSERT_EQ(range.size(), 5u);
  EXPECT_NEAR(range[2]["a"].get<double>(), 1.0, 1e-12);
  for (const char* const key : {"area_mm2", "rms_departure_mm", "max_departure_mm", "curve_miss_rms_mm", "lebesgue",
                                "g1_max_deg", "folded_cells", "willmore_energy"})
    EXPECT_TRUE(list[0][key].is_number()) << key;
  EXPECT_TRUE(list[0]["folded_cells"].is_number_integer());
  EXPECT_EQ(list[2]["rms_departure_mm"], 0.0);
}

TEST(SweepCommand, SaysWhereEverySchemeBreaksDown) {
  const json about = sweepOf({"--scheme", "all", "--a", "0.1:50:8log"});
  ASSERT_EQ(about["breakdowns"].size(), 6u);
  EXPECT_EQ(about["samples"].size(), 6u * 8u);
  EXPECT_EQ(about["breakdowns"][0]["scheme"], "four-curve");
  EXPECT_TRUE(about["breakdowns"][0]["a"].is_number());
  const auto& last = about["samples"][7];  // four-curve at a = 50: beyond a (N + 1) = 250
  EXPECT_TRUE(last["lebesgue"].is_null());
  EXPECT_FALSE(last["reason"].get<std::string>().empty());
}

TEST(SweepCommand, OneFigureHasAllSchemesAndTheirBreakdowns) {
  const TemporaryFolder folder;
  const Outcome outcome = runMien({"sweep", "--scheme", "all", "--a", "0.1:50:8log", "--resolution", "29x40", "-o",
                                   folder.file("a.svg"), "-o", folder.file("a.csv")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const std::string figure = readTextFile(folder.file("a.svg")), table = readTextFile(folder.file("a.csv"));
  for (const char* const part : {"four-curve", "derivative", "sixth-order", "tangent", "curvature", "spline",
                                 "breaks down here", "Lebesgue constant", "N = 5 with remainder", "29 × 40"})
    EXPECT_NE(figure.find(part), std::string::npos) << part;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 6 * 8);
}

TEST(SweepCommand, AReferenceAddsTheDistance) {
  MIEN_REQUIRE_REFERENCE("heads/mean_neutral.ply");
  const json samples = sweepOf({"--a", "1", "--reference", referencePath("heads/mean_neutral.ply")})["samples"];
  EXPECT_LT(samples[0]["distance_rms_mm"], 0.7);
  EXPECT_GT(samples[0]["distance_rms_mm"], 0.05);
}

TEST(SweepCommand, WrongValuesSayWhatIsAllowed) {
  for (const char* const range : {"0", "-1", "1:2", "x", "1,2000"}) {
    const Outcome outcome = runMien({"sweep", "--a", range});
    EXPECT_EQ(outcome.exitCode, 2) << range;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  }
  EXPECT_EQ(runMien({"sweep", "--reference", "nothing.ply"}).exitCode, 1);
}

}  // namespace
