#pragma once

#include "DataFile.h"
#include "FacialRegions.h"

#include <gtest/gtest.h>

/// The region map of the data folder.
inline mien::FacialRegions regionMap() {
  mien::FacialRegions regions;
  EXPECT_EQ(regions.parse(readDataFile("deformation/regions.json")), "");
  return regions;
}
