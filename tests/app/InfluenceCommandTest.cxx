#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "Program.h"

namespace {

using nlohmann::json;

TEST(InfluenceCommand, TheSurfaceFollowsTheCurveThatMovesAndForgetsItBeyond) {
  const Outcome outcome = runMien({"influence", "--curve", "C10", "--resolution", "29x40", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const json about = json::parse(outcome.output);
  ASSERT_EQ(about["profile"].size(), 29u);
  for (const json& row : about["profile"]) {
    const double distance = std::abs(row["curve"].get<double>() - 10.0);
    const double influence = row["influence_max"];
    EXPECT_TRUE(distance > 0.0 || std::abs(influence - 1.0) < 1e-9) << row;
    EXPECT_TRUE(distance < 1.0 || influence < 0.2) << row;
  }
  EXPECT_GT(about["half_width_above_curves"], 0.3);
  EXPECT_LT(about["half_width_above_curves"], 1.0);
}

TEST(InfluenceCommand, ChartsNameTheCurveAndTheSchemes) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runMien({"influence", "--curve", "C22'", "--point", "3", "--scheme", "all", "-o", folder.file("a.svg")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const std::string figure = readTextFile(folder.file("a.svg"));
  EXPECT_NE(figure.find("point 3 of C22"), std::string::npos);
  EXPECT_NE(figure.find("sixth-order"), std::string::npos);
}

TEST(InfluenceCommand, WrongValuesSayWhatIsAllowed) {
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{"--curve", "C99"},
                                                                                       {"--point", "40"},
                                                                                       {"--point", "-1"},
                                                                                       {"--direction", "0,0,0"},
                                                                                       {"--direction", "1,2"}}) {
    std::vector<std::string> arguments = {"influence"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(runMien(arguments).exitCode, 2) << options[1];
  }
}

}  // namespace
