#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "AnimationTable.h"
#include "DataFile.h"
#include "ExpressionLibrary.h"
#include "FAPTable.h"

using namespace mien;

TEST(ExpressionLibrary, TheDefaultHasSixSymmetricTreesOfFapsThatTheTableMoves) {
  ExpressionLibrary library;
  ASSERT_EQ(library.parse(readDataFile("animation/expressions.json")), "");
  ASSERT_EQ(library.expressions().size(), 6u);
  AnimationTable table;
  ASSERT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
  int select = 0;
  for (const ExpressionProfile& expression : library.expressions()) {
    EXPECT_EQ(expression.select, ++select);
    EXPECT_FALSE(expression.definition.empty());
    EXPECT_GE(expression.actions.size(), 3u);
    size_t leaves = 0;
    for (const FacialAction& action : expression.actions) {
      EXPECT_FALSE(action.name.empty());
      leaves += action.values.size();
    }
    EXPECT_EQ(leaves, expression.values.size());
    for (const auto& [fap, value] : expression.values) EXPECT_NE(table.entry(fap), nullptr) << fap;
    FAPFrame frame;
    library.add(expression.name, 1.0, frame);
    EXPECT_FALSE(frame.isNeutral());
    const FAPFrame other = mirrored(frame);
    for (int fap = 3; fap <= FAPFrame::count; ++fap) EXPECT_EQ(other.value(fap), frame.value(fap)) << expression.name;
  }
}

TEST(ExpressionLibrary, AddsWithIntensity) {
  ExpressionLibrary library;
  ASSERT_EQ(library.parse(readDataFile("animation/expressions.json")), "");
  FAPFrame full, half;
  half.setValue(53, 10.0);
  EXPECT_TRUE(library.add("joy", 1.0, full));
  EXPECT_TRUE(library.add("joy", 0.5, half));
  EXPECT_DOUBLE_EQ(half.value(53), 10.0 + 0.5 * full.value(53));
  EXPECT_FALSE(library.add("boredom", 1.0, half));
}

TEST(ExpressionLibrary, ReadsVersionOneWithoutActions) {
  ExpressionLibrary library;
  ASSERT_EQ(library.parse(R"({"format": "mien visemes", "version": 1, "expressions": [{"name": "a", "select": 1,
    "definition": "d", "faps": {"52": -90}}]})"),
            "");
  ASSERT_EQ(library.expressions()[0].actions.size(), 1u);
  EXPECT_EQ(library.expressions()[0].values, (std::vector<std::pair<int, double>>{{52, -90.0}}));
}

TEST(ExpressionLibrary, RefusesAFapInTwoActions) {
  ExpressionLibrary library;
  const std::string text = R"({"format": "mien expressions", "version": 2, "expressions": [{"name": "joy", "select": 1,
    "definition": "d", "actions": [{"name": "a", "faps": {"52": 1}}, {"name": "b", "faps": {"52": 1}}]}]})";
  EXPECT_NE(library.parse(text).find("joy: FAP 52 stands in two places"), std::string::npos);
}

TEST(ExpressionLibrary, RefusesFaultsAndNamesTheExpression) {
  ExpressionLibrary library;
  const auto fault = [&](const std::string& faps) {
    return library.parse(R"({"format": "mien expressions", "version": 1, "expressions": [{"name": "joy", "select": 1,
      "definition": "d", "faps": )" +
                         faps + "}]}");
  };
  EXPECT_EQ(fault(R"({"53": 10})"), "");
  EXPECT_NE(fault(R"({"530": 10})").find("joy: \"530\" is no FAP"), std::string::npos);
  EXPECT_NE(fault(R"({"53": "x"})").find("joy: the value of FAP 53"), std::string::npos);
  EXPECT_NE(library.parse("{").find("expressions: "), std::string::npos);
  EXPECT_NE(library.parse(R"({"format": "mien expressions", "version": 9})").find("version"), std::string::npos);
  EXPECT_EQ(library.expressions().size(), 1u);
}

TEST(ExpressionLibrary, RefusesTheMalformedFiles) {
  int files = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(std::string(MIEN_TEST_DIR) + "/data/malformed/expressions")) {
    std::ostringstream text;
    text << std::ifstream(file.path(), std::ios::binary).rdbuf();
    ExpressionLibrary library;
    const std::string fault = library.parse(text.str());
    EXPECT_FALSE(fault.empty()) << file.path();
    EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    EXPECT_TRUE(library.expressions().empty());
    ++files;
  }
  EXPECT_GE(files, 10);
}
