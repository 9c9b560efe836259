#pragma once

#include <gtest/gtest.h>

#include "FacialActionMap.h"
#include "TextFile.h"

/// The map that comes with Mien.
inline mien::FacialActionMap bundledFacialActions() {
  mien::FacialActionMap map;
  EXPECT_EQ(map.parse(readTextFile(MIEN_DATA_DIR "/animation/facs_map.json")), "");
  return map;
}
