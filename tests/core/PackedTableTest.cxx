#include "PackedTable.h"
#include "RegionMap.h"
#include "TableText.h"

using namespace mien;

namespace {

DeformationTable meanOf(const std::string& expression) {
  DeformationTable table;
  EXPECT_EQ(parseTable(readDataFile("deformation/" + expression + ".csv"), table), "");
  return table;
}

/// Largest difference of displacements within `reach` of the regions' centres.
double largestError(const DeformationTable& a, const DeformationTable& b, double reach) {
  const FacialRegions regions = regionMap();
  double largest = 0.0;
  for (int region = 1; region <= 16; ++region)
    for (double x = -reach; x <= reach; x += reach / 8)
      for (double y = -reach; y <= reach; y += reach / 8)
        if (std::hypot(x, y) <= reach) {
          const Eigen::Vector2d point = regions.centre(region) + Eigen::Vector2d(x, y);
          largest = std::max(largest, (a.maps[region - 1].apply(point) - b.maps[region - 1].apply(point)).norm());
        }
  return largest;
}

}  // namespace

TEST(PackedTable, ErrorsStayBelowTheirBound) {
  for (const char* expression : {"anger", "disgust", "fear", "joy", "sadness", "surprise"})
    for (const int bits : {8, 16}) {
      const DeformationTable table = meanOf(expression);
      const std::string bytes = packTable(table, bits);
      EXPECT_EQ(bytes.size(), bits == 8 ? 220u : 412u);
      DeformationTable read;
      ASSERT_EQ(unpackTable(bytes, read), "");
      EXPECT_NEAR(read.largestDisplacement, table.largestDisplacement, 1e-7);
      const double bound = packingError(table, bits, 0.8), error = largestError(table, read, 0.8);
      EXPECT_LE(error, bound + 1e-12) << expression;
      EXPECT_GT(error, 0.05 * bound) << "else the bound says nothing";
      // Pupil units; half the distance of the pupils is about 31 mm: 0.001 mm at 16 bits, 0.12 mm at 8.
      EXPECT_LT(error, bits == 8 ? 0.005 : 0.00002) << expression;
    }
}

TEST(PackedTable, TheIdentityStaysTheIdentity) {
  DeformationTable read = meanOf("joy");
  ASSERT_EQ(unpackTable(packTable(DeformationTable(), 8), read), "");
  for (const QuadraticMap& map : read.maps)
    EXPECT_LT((map.coefficients - QuadraticMap::identity()).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(PackedTable, FilesOfVersion1AreStillRead) {
  std::string bytes = packTable(meanOf("joy"), 16);
  DeformationTable now, before;
  ASSERT_EQ(unpackTable(bytes, now), "");
  bytes.resize(bytes.size() - 4);
  bytes[4] = 1;
  ASSERT_EQ(unpackTable(bytes, before), "");
  for (int i = 0; i < 16; ++i) EXPECT_EQ(before.maps[i].coefficients, now.maps[i].coefficients);
  bytes[15] = char(0xff);
  EXPECT_NE(unpackTable(bytes, before).find("step"), std::string::npos);
}

TEST(PackedTable, WhatNoFileMayHoldIsNotPacked) {
  DeformationTable table = meanOf("joy");
  for (const int bits : {8, 16}) {
    EXPECT_EQ(describePacking(table, bits), "");
    DeformationTable vast = table, far = table;
    vast.maps[3].coefficients(0, 0) = 1e12;
    far.largestDisplacement = 2e6;
    EXPECT_NE(describePacking(vast, bits).find("coefficients"), std::string::npos);
    EXPECT_NE(describePacking(far, bits).find("displacement"), std::string::npos);
    vast.maps[3].coefficients(0, 0) = 1e300;
    EXPECT_NE(describePacking(vast, bits), "");
  }
}

TEST(PackedTable, RegionsThatAreNotKnownStaySo) {
  DeformationTable table = meanOf("joy");
  table.counts.emplace().fill(1);
  EXPECT_EQ(packTable(table, 8)[4], 2) << "older programs read tables that know every region";
  for (const int region : {1, 9, 16}) table.counts->at(region - 1) = 0;
  for (const int bits : {8, 16}) {
    DeformationTable read;
    ASSERT_EQ(unpackTable(packTable(table, bits), read), "");
    EXPECT_EQ(read.unknownRegions(), (std::vector<int>{1, 9, 16}));
  }
}

TEST(PackedTable, DamagedBytesAreRefusedAndNothingIsLoaded) {
  const std::string good = packTable(meanOf("joy"), 16);
  DeformationTable table;
  const auto fault = [&](std::size_t at, char byte) {
    std::string bytes = good;
    bytes[at] = byte;
    return unpackTable(bytes, table);
  };
  EXPECT_NE(fault(0, 'X').find("no packed"), std::string::npos);
  EXPECT_NE(fault(4, 4).find("version is 4"), std::string::npos);
  EXPECT_NE(fault(5, 12).find("12 bits"), std::string::npos);
  EXPECT_NE(fault(5, 8).find("412 bytes where a table has 220"), std::string::npos);
  EXPECT_NE(fault(7, 1).find("damaged"), std::string::npos);
  for (std::size_t at = 8; at < good.size(); ++at)
    ASSERT_NE(fault(at, static_cast<char>(good[at] ^ 0x10)).find("checksum"), std::string::npos) << at;
  EXPECT_NE(fault(4, 1).find("412 bytes where a table has 408"), std::string::npos) << "version 1 has no checksum";
  EXPECT_NE(unpackTable("", table), "");
  EXPECT_NE(unpackTable("MFDT", table), "");
  EXPECT_NE(unpackTable(good.substr(0, 400), table), "");
  EXPECT_EQ(table.largestDisplacement, 0.0);
}

TEST(PackedTable, CoefficientsAndDisplacementsBeyondTheLimitAreRefused) {
  for (const int bits : {8, 16}) {
    DeformationTable table, read;
    table.maps[6].coefficients(1, 4) = 99.0;
    table.largestDisplacement = 99.0;
    EXPECT_EQ(unpackTable(packTable(table, bits), read), "");
    EXPECT_NEAR(read.maps[6].coefficients(1, 4), 99.0, bits == 8 ? 0.5 : 0.002);
    for (const double beyond : {102.0, -102.0}) {
      DeformationTable steep = table, before = read;
      steep.maps[6].coefficients(1, 4) = beyond;
      const std::string fault = unpackTable(packTable(steep, bits), read);
      EXPECT_NE(fault.find("region 7 has a coefficient beyond -100 .. 100"), std::string::npos) << fault;
      EXPECT_EQ(read.maps[6].coefficients, before.maps[6].coefficients);
    }
    table.largestDisplacement = 101.0;
    const std::string fault = unpackTable(packTable(table, bits), read);
    EXPECT_NE(fault.find("largest displacement is beyond 100"), std::string::npos) << fault;
  }
}
