#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

/// Heads, markers and .fap files that are not part of the repository; tests that use them skip without them.
inline std::string referencePath(const std::string& relative) {
  return std::string(MIEN_REFERENCE_DIR) + "/" + relative;
}

#define MIEN_REQUIRE_REFERENCE(relative)                 \
  if (!std::filesystem::exists(referencePath(relative))) \
  GTEST_SKIP() << referencePath(relative) << " is not here; this test needs it"
