#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "Program.h"

namespace {

using nlohmann::json;

json spectrumOf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"spectrum", "--json"});
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return json::parse(outcome.output, nullptr, false);
}

TEST(SpectrumCommand, SharesOfTheEnergySumToOneAndTheErrorFallsToNothing) {
  const json modes = spectrumOf({"-N", "8"})["modes"];
  ASSERT_EQ(modes.size(), 10u);
  EXPECT_EQ(modes[0]["n"], 0);
  EXPECT_EQ(modes[9]["n"], "remainder");
  double sum = 0.0;
  for (const json& mode : modes) sum += mode["energy_share"].get<double>();
  EXPECT_NEAR(sum, 1.0, 1e-12);
  for (size_t i = 1; i < modes.size(); ++i)
    EXPECT_LT(modes[i]["cumulative_rms_error_mm"], modes[i - 1]["cumulative_rms_error_mm"]);
  EXPECT_LT(modes[9]["cumulative_rms_error_mm"], 1e-9);
}

/// The smallest N by the tolerance is the one whose own spectrum over all modes says so.
TEST(SpectrumCommand, ToleranceNamesTheSmallestN) {
  const int count = spectrumOf({"--tolerance", "0.1mm"})["smallest_harmonics"];
  const json modes = spectrumOf({"-N", "20"})["modes"];
  ASSERT_GT(count, 0);
  EXPECT_LE(modes[count]["cumulative_rms_error_mm"], 0.1);
  EXPECT_GT(modes[count - 1]["cumulative_rms_error_mm"], 0.1);
}

TEST(SpectrumCommand, ChartsAndTablesSayTheScheme) {
  const TemporaryFolder folder;
  const Outcome outcome =
      runMien({"spectrum", "--scheme", "tangent", "-o", folder.file("a.svg"), "-o", folder.file("a.pdf"), "-o",
               folder.file("a.png"), "-o", folder.file("a.csv"), "--width", "85", "--dpi", "100"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  EXPECT_NE(readTextFile(folder.file("a.svg")).find("tangent"), std::string::npos);
  EXPECT_EQ(readTextFile(folder.file("a.csv"))
                .rfind("scheme,n,rms_mm,max_mm,energy_share,cumulative_rms_error_mm\ntangent,0,", 0),
            0u);
  EXPECT_EQ(readTextFile(folder.file("a.pdf")).substr(0, 5), "%PDF-");
}

TEST(SpectrumCommand, WrongValuesSayWhatIsAllowed) {
  const Outcome modes = runMien({"spectrum", "-N", "21"});
  EXPECT_EQ(modes.exitCode, 2);
  EXPECT_NE(modes.errors.find("0 .. 20"), std::string::npos) << modes.errors;
  EXPECT_EQ(runMien({"spectrum", "--tolerance", "0mm"}).exitCode, 2);
  EXPECT_EQ(runMien({"spectrum", "--tolerance", "1 furlong"}).exitCode, 2);
}

}  // namespace
