#pragma once

#include <gtest/gtest.h>

#include "TableText.h"
#include "TextFile.h"

inline mien::DeformationTable tableFrom(const std::string& file) {
  mien::DeformationTable table;
  EXPECT_EQ(mien::parseTable(readTextFile(file), table), "") << file;
  return table;
}

/// The largest difference of two tables' coefficients.
inline double tableDifference(const mien::DeformationTable& a, const mien::DeformationTable& b) {
  double largest = 0.0;
  for (int i = 0; i < 16; ++i)
    largest = std::max(largest, (a.maps[i].coefficients - b.maps[i].coefficients).cwiseAbs().maxCoeff());
  return largest;
}
