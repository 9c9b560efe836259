#pragma once

#include <gtest/gtest.h>

#include "DataFile.h"
#include "FacialRegions.h"

/// The region map of the data folder.
inline mien::FacialRegions regionMap() {
  mien::FacialRegions regions;
  EXPECT_EQ(regions.parse(readDataFile("deformation/regions.json")), "");
  return regions;
}
