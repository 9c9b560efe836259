#include <gtest/gtest.h>

#include "AnimationTable.h"
#include "DataFile.h"
#include "FAPTable.h"

using namespace mien;

namespace {

const char* const goodTable = R"({"format": "mien animation table", "version": 1,
  "contacts": [{"name": "lips", "upper": "C22", "lower": "C22'", "yields": "both"}],
  "faps": [{"fap": 6, "borders": [-1000, 0, 500, 1000], "parts": [{"curves": ["C22"], "above": "C20",
    "slopes": [[1, 0, 0], [0.9, 0, 0], [1.5, 0, 4]],
    "profile": {"shape": "linear", "knots": [["8.1", 0], ["8.3+2.5", 1, "sinusoid"], ["8.3+50", 0]]}}]}]})";

/// The fault of the good table after a piece of it is replaced.
std::string faultWith(const std::string& from, const std::string& to) {
  std::string text = goodTable;
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  AnimationTable table;
  return table.parse(text.replace(at, from.size(), to));
}

}  // namespace

TEST(AnimationTable, ReadsWhatIsWritten) {
  AnimationTable table;
  ASSERT_EQ(table.parse(goodTable), "");
  const AnimationEntry* entry = table.entry(6);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(table.entry(7), nullptr);
  ASSERT_EQ(entry->parts.size(), 1u);
  const AnimationPart& part = entry->parts[0];
  EXPECT_EQ(part.curves, std::vector<int>{FaceLayout::upperLip});
  EXPECT_EQ(part.follow, FollowerShape::Linear);
  EXPECT_EQ(part.slopes[2], Eigen::Vector3d(1.5, 0, 4));
  EXPECT_EQ(part.profile.knots[1].feature, "8.3");
  EXPECT_NEAR(part.profile.knots[1].offset, 2.5 * M_PI / 180.0, 1e-15);
  EXPECT_EQ(part.profile.knots[1].shape, ProfileShape::Sinusoid);
  EXPECT_EQ(table.contacts().size(), 1u);
}

TEST(AnimationTable, RefusesFaultsAndNamesTheEntry) {
  const auto expectFault = [](const std::string& fault, const char* part) {
    EXPECT_NE(fault.find(part), std::string::npos) << fault;
  };
  expectFault(faultWith("{\"format\"", "{format"), "no valid JSON");
  expectFault(faultWith("\"version\": 1", "\"version\": 4"), "version");
  expectFault(faultWith("mien animation table", "something"), "format");
  expectFault(faultWith("[\"C22\"]", "[\"C40\"]"), "FAP 6: curve \"C40\" is unknown");
  expectFault(faultWith("[-1000, 0, 500, 1000]", "[-1000, 0, 1000, 500]"), "FAP 6: borders must ascend");
  expectFault(faultWith("[-1000, 0, 500, 1000]", "[-1000, 10, 500, 1000]"), "FAP 6: one of the borders must be 0");
  expectFault(faultWith("[-1000, 0, 500, 1000]", "[-1000, \"x\"]"), "FAP 6: ");
  expectFault(faultWith("[1, 0, 0],", ""), "FAP 6: there are 2 slopes for 3 intervals");
  expectFault(faultWith("[1, 0, 0]", "[1, 0]"), "FAP 6: a slope must be three numbers");
  expectFault(faultWith("\"linear\"", "\"wavy\""), "FAP 6: shape \"wavy\" is unknown");
  expectFault(faultWith("8.3+2.5", "8.3+wide"), "FAP 6: the offset");
  expectFault(faultWith("8.3+2.5", "nose"), "FAP 6: \"nose\" is no place");
  expectFault(faultWith("\"fap\": 6", "\"fap\": 2"), "entry 1: fap must be a whole number from 3 to 68");
  expectFault(faultWith("\"fap\": 6", "\"fap\": 48"), "FAP 48: it turns by an angle");
  expectFault(faultWith("\"above\": \"C20\"", "\"above\": \"C23\""), "FAP 6: \"above\"");
  expectFault(faultWith("\"above\": \"C20\"", "\"above\": \"C20\", \"follow\": \"wavy\""),
              "FAP 6: \"follow\" is \"wavy\"");
  expectFault(faultWith("\"above\"", "\"abvoe\""), "FAP 6: the key \"abvoe\" is unknown");
  expectFault(faultWith("\"fap\": 6,", "\"fap\": 6, \"beyond\": [53],"),
              "FAP 6: the entry of FAP 53 must stand before");
  expectFault(faultWith("\"fap\": 6,", "\"fap\": 6, \"replaces\": 53,"), "FAP 6: \"replaces\" must be a list");
  expectFault(faultWith("\"fap\": 6,", "\"fap\": 6, \"lends\": [{\"fap\": 53, \"share\": 0.5}],"),
              "FAP 6: it lends to FAP 53, which has no entry");
  expectFault(faultWith("\"fap\": 6,", "\"fap\": 6, \"lends\": [{\"fap\": 53, \"share\": 5}],"),
              "FAP 6: a share must lie");
  expectFault(faultWith("\"contacts\"", "\"sideways\": [{\"first\": \"C9\", \"last\": \"C2\"}], \"contacts\""),
              "sideways: \"first\" must not come after");
  expectFault(faultWith("\"yields\": \"both\"", "\"yields\": \"none\""), "contacts: \"yields\"");
}

TEST(AnimationTable, AFaultLeavesTheTableAsItWas) {
  AnimationTable table;
  ASSERT_EQ(table.parse(goodTable), "");
  EXPECT_NE(table.parse("[1, 2"), "");
  EXPECT_NE(table.parse(std::string(100000, '[')), "");
  EXPECT_NE(table.entry(6), nullptr);
}

TEST(AnimationTable, TheDefaultHasTheFapsOfThePaper) {
  AnimationTable table;
  ASSERT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
  for (int fap : paperSubset()) EXPECT_NE(table.entry(fap), nullptr) << fap;
}
