#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <locale>

#include "FAPParser.h"
#include "FAPText.h"
#include "FAPWriter.h"

using namespace mien;

namespace {

const std::string header = "2.1 made up 25 1\n";

FAPSequence parsed(const std::string& text) {
  FAPSequence sequence;
  const auto error = parseFAP(text, sequence);
  EXPECT_FALSE(error.has_value()) << error->line << ": " << error->message;
  return sequence;
}

std::string oneFrame(std::initializer_list<int> faps, const std::string& values) {
  return header + maskText(faps) + "\n" + values + "\n";
}

}  // namespace

TEST(FAPParser, ReadsHeaderMaskAndValues) {
  const FAPSequence sequence =
      parsed("2.0 C:\\my files\\a  b 29.97 2\n" + maskText({3, 68}) + "\n1 10.5 -20\n" + maskText({53}) + "\n2 +3e1\n");
  EXPECT_EQ(sequence.version, "2.0");
  EXPECT_EQ(sequence.name, "C:\\my files\\a  b");
  EXPECT_EQ(sequence.framesPerSecond, 29.97);
  EXPECT_EQ(sequence.declaredFrameCount, 2);
  ASSERT_EQ(sequence.frames.size(), 2u);
  EXPECT_EQ(sequence.frames[0].number, 1.0);
  EXPECT_EQ(sequence.frames[0].value(3), 10.5);
  EXPECT_EQ(sequence.frames[0].value(68), -20.0);
  EXPECT_EQ(sequence.frames[1].value(53), 30.0);
  EXPECT_EQ(sequence.frames[1].value(3), 0.0) << "a FAP whose mask is 0 is 0, not what it was before";
  EXPECT_EQ(sequence.fapsUsed(), (std::vector<int>{3, 53, 68}));
  EXPECT_TRUE(sequence.warnings.empty());
}

TEST(FAPParser, LineEndingsBlanksTabsAndCommentsDoNotMatter) {
  const std::string mask = maskText({53, 54});
  std::string tabbed = mask;
  std::replace(tabbed.begin(), tabbed.end(), ' ', '\t');
  const std::vector<std::string> texts = {
      "2.1 n 25 1\n" + mask + "\n0 5 6\n", "2.1 n 25 1\r\n" + mask + " \r\n0 5 6 \r\n",
      "2.1 n 25 1\r" + mask + "\r0 5 6", "\xEF\xBB\xBF# mark\n2.1 n 25 1\n" + mask + "\n0 5 6",
      "\n\n# a\n  # b\n2.1\tn\t25\t1  \n\n#\n" + tabbed + "\t\n# c\n\n\t0\t5\t6\t\n# end\n\n"};
  for (const std::string& text : texts) {
    const FAPSequence sequence = parsed(text);
    EXPECT_EQ(sequence.name, "n");
    ASSERT_EQ(sequence.frames.size(), 1u);
    EXPECT_EQ(sequence.frames[0].value(53), 5.0);
    EXPECT_EQ(sequence.frames[0].value(54), 6.0);
    EXPECT_TRUE(sequence.warnings.empty());
  }
}

TEST(FAPParser, AMaskOf69EntriesIsReadWithoutTheLast) {
  const FAPSequence sequence = parsed(header + "# c\n" + maskText({53, 69}, 69) + "\n0 7 99\n");
  EXPECT_EQ(sequence.frames[0].value(53), 7.0);
  EXPECT_EQ(sequence.fapsUsed(), (std::vector<int>{53}));
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 3);
}

TEST(FAPParser, AnEmptyMaskIsReadAndAbsurdMagnitudesAreLimitedWithAWarning) {
  EXPECT_TRUE(parsed(oneFrame({}, "0")).fapsUsed().empty());
  const FAPSequence sequence = parsed(oneFrame({48, 49, 50}, "0 1e6 -1e300 2e6"));
  EXPECT_EQ(sequence.frames[0].value(48), 1e6);
  EXPECT_EQ(sequence.frames[0].value(49), -1e6);
  EXPECT_EQ(sequence.frames[0].value(50), 1e6);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 3);
  EXPECT_EQ(sequence.warnings[0].message, "FAP 49 is -1e+300; FAP values lie within +-1e6, it was limited");
}

TEST(FAPParser, CommentsStandBehindTheEntriesOfALineToo) {
  const FAPSequence sequence = parsed("2.1 take #2 25 1 # h\n" + maskText({53, 54}) + " # the lips\n0 10 -20# 3 4\n");
  EXPECT_EQ(sequence.frames[0].value(53), 10.0);
  EXPECT_EQ(sequence.frames[0].value(54), -20.0);
  EXPECT_EQ(sequence.name, "take #2");
  const FAPSequence numbers = parsed("2.1 x 25 1 # takes 3 4\n" + maskText({53}) + "\n0 10\n");
  EXPECT_EQ(numbers.name, "x");
  EXPECT_EQ(numbers.framesPerSecond, 25.0);
  EXPECT_TRUE(sequence.warnings.empty());
}

TEST(FAPParser, VisemesHaveFourValuesAndExpressionsSix) {
  const FAPSequence sequence = parsed(oneFrame({1, 2, 3}, "0 1 14 31.5 1 6 63 2 10 0 1 500"));
  const FAPFrame& frame = sequence.frames[0];
  EXPECT_EQ(frame.viseme.select1, 1.0);
  EXPECT_EQ(frame.viseme.select2, 14.0);
  EXPECT_EQ(frame.viseme.blend, 31.5);
  EXPECT_EQ(frame.viseme.definition, 1.0);
  EXPECT_EQ(frame.expression.select1, 6.0);
  EXPECT_EQ(frame.expression.intensity1, 63.0);
  EXPECT_EQ(frame.expression.select2, 2.0);
  EXPECT_EQ(frame.expression.intensity2, 10.0);
  EXPECT_EQ(frame.expression.initialFace, 0.0);
  EXPECT_EQ(frame.expression.definition, 1.0);
  EXPECT_EQ(frame.value(3), 500.0);
  EXPECT_EQ(sequence.fapsUsed(), (std::vector<int>{1, 2, 3}));
}

TEST(FAPParser, VisemeOrExpressionAlone) {
  EXPECT_EQ(parsed(oneFrame({1, 68}, "0 1 2 3 1 500")).frames[0].value(68), 500.0);
  EXPECT_EQ(parsed(oneFrame({2, 68}, "0 1 2 3 4 1 0 500")).frames[0].value(68), 500.0);
}

TEST(FAPParser, SingleValuesForVisemeAndExpressionAreSelectionsWithAWarning) {
  const FAPSequence sequence = parsed(oneFrame({1, 2, 53}, "0 5 3 200"));
  EXPECT_EQ(sequence.frames[0].viseme.select1, 5.0);
  EXPECT_EQ(sequence.frames[0].viseme.blend, 63.0);
  EXPECT_EQ(sequence.frames[0].expression.select1, 3.0);
  EXPECT_EQ(sequence.frames[0].expression.intensity1, 63.0);
  EXPECT_EQ(sequence.frames[0].value(53), 200.0);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 3);
  EXPECT_TRUE(parsed(oneFrame({1, 2, 53}, "0 0 0 200")).frames[0].viseme.blend == 0.0);
}

TEST(FAPParser, SelectionsAndWeightsOutOfRangeAreLimitedWithAWarning) {
  const FAPSequence sequence = parsed(oneFrame({1, 2}, "0 15 1.5 64 7 -1 -2 6 1000 2 0"));
  const FAPFrame& frame = sequence.frames[0];
  EXPECT_EQ(frame.viseme.select1, 0.0);
  EXPECT_EQ(frame.viseme.select2, 0.0);
  EXPECT_EQ(frame.viseme.blend, 63.0);
  EXPECT_EQ(frame.viseme.definition, 1.0);
  EXPECT_EQ(frame.expression.select1, 0.0);
  EXPECT_EQ(frame.expression.intensity1, 0.0);
  EXPECT_EQ(frame.expression.select2, 6.0);
  EXPECT_EQ(frame.expression.intensity2, 63.0);
  EXPECT_EQ(frame.expression.initialFace, 1.0);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 3);
}

TEST(FAPParser, FramesAreCountedFromTheDataWhateverTheHeaderSays) {
  for (const char* count : {"2", "0", "-3", "99999999999999999999999", "2000000000"}) {
    const FAPSequence sequence = parsed(std::string("# c\n2.1 n 25 ") + count + "\n" + maskText({53}) + "\n0 1\n");
    EXPECT_EQ(sequence.frames.size(), 1u);
    ASSERT_EQ(sequence.warnings.size(), 1u) << count;
    EXPECT_EQ(sequence.warnings[0].line, 2);
    EXPECT_EQ(sequence.warnings[0].message.rfind(std::string("the header says ") + count + " frames", 0), 0u)
        << sequence.warnings[0].message;
  }
}

TEST(FAPParser, WithoutAHeaderTheRateIs25) {
  const FAPSequence sequence = parsed(maskText({53}) + "\n0 1\n" + maskText({53}) + "\n1 2\n");
  EXPECT_EQ(sequence.framesPerSecond, 25.0);
  EXPECT_EQ(sequence.frames.size(), 2u);
  EXPECT_EQ(sequence.version, "");
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 1);
}

TEST(FAPParser, MillisecondFrameNumbersGiveTheRateWithALoneIntegerOrNothingForAHeader) {
  const std::string frames = maskText({53}) + "\n0 1\n" + maskText({53}) + "\n20 2\n" + maskText({53}) + "\n40 3\n";
  for (const char* first : {"", "3\n", "# c\n\n1500\n"}) {
    const FAPSequence sequence = parsed(first + frames);
    EXPECT_EQ(sequence.framesPerSecond, 50.0);
    EXPECT_EQ(sequence.frames.size(), 3u);
    EXPECT_EQ(sequence.indexOfNumber(40.0), std::optional<std::size_t>(2));
    EXPECT_EQ(sequence.warnings.size(), 1u);
  }
}

TEST(FAPParser, FrameNumbersThatDoNotIncreaseAreWarnedOf) {
  const FAPSequence sequence = parsed("2.1 n 25 2\n" + maskText({53}) + "\n5 1\n" + maskText({53}) + "\n5 2\n");
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 5);
}

TEST(FAPParser, FramesThatAreMissingAreWarnedOf) {
  const auto warned = [](const std::string& header, std::initializer_list<int> numbers) {
    std::string text = header;
    for (const int number : numbers) text += maskText({53}) + "\n" + std::to_string(number) + " 1\n";
    const auto warnings = parsed(text).warnings;
    return warnings.empty() ? "" : std::to_string(warnings.back().line) + ": " + warnings.back().message;
  };
  const std::string after = "; those that are there play one after the other, 10 per second";
  EXPECT_EQ(warned("2.1 n 10 3\n", {0, 1, 10}), "7: frames 2 to 9 are missing" + after);
  EXPECT_EQ(warned("2.1 n 10 3\n", {7, 8, 10}), "7: frame 9 is missing" + after);
  EXPECT_EQ(warned("2.1 n 10 5\n", {1, 5, 6, 8, 9}), "5: frames 2 to 4 are missing (in all 4 in 2 gaps)" + after);
  EXPECT_EQ(warned("2.1 n 10 3\n", {0, 2, 4}), "5: the frame numbers step by 2" + after);
  EXPECT_EQ(warned("2.1 n 10 4\n", {0, 100, 200, 500}), "9: frames between 200 and 500 are missing" + after);
  EXPECT_EQ(warned("2.1 n 10 3\n", {0, 100, 200}), "") << "milliseconds";
  EXPECT_EQ(warned("2.1 n 30 4\n", {0, 33, 67, 100}), "") << "rounded milliseconds";
  EXPECT_EQ(warned("2.1 n 10 3\n", {3, 4, 5}), "");
}

TEST(FAPParser, EachKindOfWarningComesOnceAndInTheOrderOfTheLines) {
  std::string text = "2.1 n 25 7\n";
  for (int i = 0; i < 100; ++i) text += maskText({1, 53}, 69) + "\n" + std::to_string(i) + " 99 2\n";
  const FAPSequence sequence = parsed(text);
  ASSERT_EQ(sequence.warnings.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_LE(sequence.warnings[i - 1].line, sequence.warnings[i].line);
}

TEST(FAPParser, NamesMayBeMissingOrLookLikeNumbers) {
  const std::string frame = "\n" + maskText({}) + "\n0\n";
  EXPECT_EQ(parsed("2.1 25 1" + frame).name, "");
  EXPECT_EQ(parsed("2.1 7 8 25 1" + frame).name, "7 8");
  EXPECT_EQ(parsed("2.1 take #2 25 1" + frame).name, "take #2");
}

TEST(FAPParser, NumbersAreReadAndWrittenTheSameWhereTheDecimalPointIsAComma) {
  struct CommaPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed; the facet is there always
  const std::locale classic = std::locale::global(std::locale(std::locale::classic(), new CommaPoint));
  const FAPSequence sequence = parsed(oneFrame({53}, "0 1.5"));
  std::string text;
  const std::string fault = writeFAP(sequence, text);
  std::locale::global(classic);
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_EQ(sequence.frames[0].value(53), 1.5);
  EXPECT_EQ(fault, "");
  EXPECT_NE(text.find("\n0 1.5\n"), std::string::npos);
}
