#include <gtest/gtest.h>

#include <filesystem>

#include "FAPParser.h"
#include "TextFile.h"

using namespace mien;

namespace {

/// The files are called lineN_what.fap, N being the line that must be named.
int lineInName(const std::string& name) {
  return std::stoi(name.substr(4));
}

}  // namespace

TEST(FAPMalformed, EveryFileIsRefusedWithItsLineAndNothingIsLoaded) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/fap")) {
    const std::string name = entry.path().filename().string();
    FAPSequence sequence;
    sequence.name = "the one before";
    const auto error = parseFAP(readTextFile(entry.path().string()), sequence);
    ASSERT_TRUE(error.has_value()) << name;
    EXPECT_EQ(error->line, lineInName(name)) << name << ": " << error->message;
    EXPECT_GT(error->message.size(), 20u) << name;
    EXPECT_EQ(sequence.name, "the one before") << name;
    EXPECT_TRUE(sequence.frames.empty()) << name;
    ++files;
  }
  EXPECT_GE(files, 37);
}

TEST(FAPMalformed, AnOverlongLineIsRefusedWithTheLimit) {
  const std::string text = "2.1 long 25 1\n" + std::string(longestFAPLine, ' ') + "1\n";
  FAPSequence sequence;
  const auto error = parseFAP(text, sequence);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->line, 2);
  EXPECT_NE(error->message.find("65536"), std::string::npos);
}

TEST(FAPMalformed, MessagesQuoteControlCharactersHarmlessly) {
  FAPSequence sequence;
  const auto error = parseFAP("2.1 name \x1b[31m 1\n", sequence);
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->message.find('\x1b'), std::string::npos);
}
