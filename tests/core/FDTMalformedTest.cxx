#include <filesystem>

#include "MarkerTable.h"
#include "RegionMap.h"
#include "TableText.h"

using namespace mien;

namespace {

/// Calls parse(text) for each file of a folder; the files are called lineN_what, N being the line that must be named.
template <class Parse>
int forFiles(const std::string& folder, const Parse& parse) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/" + folder)) {
    const std::string name = entry.path().filename().string();
    const std::string fault = parse(readTextFile(entry.path().string()));
    EXPECT_GT(fault.size(), 20u) << name << ": " << fault;
    if (name.rfind("line", 0) == 0) {
      EXPECT_EQ(std::stoi(fault), std::stoi(name.substr(4))) << name << ": " << fault;
    }
    ++files;
  }
  return files;
}

}  // namespace

TEST(FDTMalformed, TablesAreRefusedWithTheirLineAndStayAsTheyWere) {
  const int files = forFiles("fdt", [](const std::string& text) {
    DeformationTable table;
    table.largestDisplacement = 0.25;
    const std::string fault = parseTable(text, table);
    EXPECT_EQ(table.largestDisplacement, 0.25);
    return fault;
  });
  EXPECT_GE(files, 14);
}

TEST(FDTMalformed, RecordingsAreRefusedWithTheirLineAndStayAsTheyWere) {
  const int files = forFiles("markers", [](const std::string& text) {
    MarkerTable table;
    table.missing = {"before"};
    const std::string fault = table.parse(text);
    EXPECT_EQ(table.missing, std::vector<std::string>{"before"});
    return fault;
  });
  EXPECT_GE(files, 16);
}

TEST(FDTMalformed, MarkersOfOneStateAreRefusedWithTheirLineAndStayAsTheyWere) {
  const int files = forFiles("points", [](const std::string& text) {
    PointTable table;
    const std::string fault = table.parse(text);
    EXPECT_TRUE(table.points.empty());
    return fault;
  });
  EXPECT_GE(files, 12);
}

TEST(FDTMalformed, RegionMapsAreRefusedAndStayAsTheyWere) {
  const int files = forFiles("regions", [](const std::string& text) {
    FacialRegions regions = regionMap();
    const std::string fault = regions.parse(text);
    EXPECT_EQ(regions.name(16), "chin");
    EXPECT_EQ(fault.rfind("region map: ", 0), 0u) << fault;
    EXPECT_EQ(fault.find("json.exception"), std::string::npos) << fault;
    return fault;
  });
  EXPECT_GE(files, 17);
}
