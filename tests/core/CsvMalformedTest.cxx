#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "CaptureParser.h"
#include "FAPCsvParser.h"
#include "FacialActions.h"

using namespace mien;

namespace {

using Parse = std::function<std::optional<FAPParseError>(const std::string& text, FAPSequence& sequence)>;

/// Every file of a folder, called lineN_what.csv, is refused with line N, and nothing is loaded.
void expectRefused(const std::string& folder, int fewest, const Parse& parse) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/" + folder)) {
    const std::string name = entry.path().filename().string();
    FAPSequence sequence;
    sequence.name = "the one before";
    const auto error = parse(readTextFile(entry.path().string()), sequence);
    ASSERT_TRUE(error.has_value()) << name;
    EXPECT_EQ(error->line, std::stoi(name.substr(4))) << name << ": " << error->message;
    EXPECT_GT(error->message.size(), 20u) << name;
    EXPECT_EQ(sequence.name, "the one before") << name;
    EXPECT_TRUE(sequence.frames.empty()) << name;
    ++files;
  }
  EXPECT_GE(files, fewest);
}

}  // namespace

TEST(CsvMalformed, TablesOfFAPsAreRefusedWithTheirLine) {
  expectRefused("fap_csv", 16, parseFAPCsv);
}

TEST(CsvMalformed, TablesOfCaptureAreRefusedWithTheirLine) {
  const FacialActionMap map = bundledFacialActions();
  for (const CaptureKind kind : {CaptureKind::Blendshapes, CaptureKind::ActionUnits})
    expectRefused("capture", 14, [&](const std::string& text, FAPSequence& sequence) {
      return parseCapture(text, kind, map, sequence);
    });
}
