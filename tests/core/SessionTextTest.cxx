#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "SessionText.h"

namespace {

using json = nlohmann::json;

TEST(SessionText, IsReadBackAsItWasWritten) {
  const json session = {{"face", {{"mien_face_state", 2}, {"a", {0.1, 1.0 / 3.0, -0.0, 1e-300}}}},
                        {"docks", {{"x", true}}}};
  const std::string text = mien::writeSession(session);
  EXPECT_EQ(text.rfind("{\n \"format\": \"mien session\",\n \"version\": 1,", 0), 0u) << text;
  json read;
  ASSERT_EQ(mien::readSession(text, read), "");
  EXPECT_EQ(read["face"], session["face"]);
  EXPECT_EQ(read["docks"], session["docks"]);
}

TEST(SessionText, AFaceStateAloneIsASession) {
  json read;
  ASSERT_EQ(mien::readSession("{\"mien_face_state\": 2, \"format\": 1}", read), "");
  EXPECT_EQ(read, json({{"face", {{"mien_face_state", 2}, {"format", 1}}}}));
}

TEST(SessionText, ARefusalLeavesTheSessionAlone) {
  json session = {{"face", 1}};
  const json before = session;
  for (const char* text :
       {"", "{", "[]", "3", "{}", "{\"format\": \"mien session\"}", "{\"format\": \"mien session\", \"version\": 2}",
        "{\"format\": \"mien session\", \"version\": 1.5}", "{\"format\": \"mien session\", \"version\": 1e999}"}) {
    EXPECT_NE(mien::readSession(text, session), "") << text;
    EXPECT_EQ(session, before) << text;
  }
}

/// Copies of lists within lists within lists would exhaust the stack.
TEST(SessionText, WhatIsNestedWithoutSenseIsLeftOut) {
  constexpr int levels = 1000000;
  const std::string deep = std::string(levels, '[') + std::string(levels, ']');
  json session;
  ASSERT_EQ(mien::readSession("{\"format\": \"mien session\", \"version\": 1, \"x\": " + deep + "}", session), "");
  const json copy = session;
  EXPECT_LT(copy.dump().size(), 200u);
}

/// Objects within objects, lists, numbers and texts by chance; no null.
json randomDocument(std::mt19937& random, int depth) {
  const auto pick = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  switch (pick(depth > 0 ? 6 : 4)) {
    case 0:
      return pick(5);
    case 1:
      return 0.1 * pick(5);
    case 2:
      return std::string(1, static_cast<char>('a' + pick(3)));
    case 3:
      return pick(2) == 0;
    case 4:
      return json::array({pick(3), pick(3)});
    default: {
      json object = json::object();
      for (int i = pick(5); i > 0; --i)
        object[std::string(1, static_cast<char>('a' + pick(6)))] = randomDocument(random, depth - 1);
      return object;
    }
  }
}

TEST(SessionText, DifferencesLeadFromAnyDocumentToAnyOther) {
  std::mt19937 random(7);
  for (int i = 0; i < 5000; ++i) {
    json from = {{"x", randomDocument(random, 4)}}, to = {{"x", randomDocument(random, 4)}};
    const json there = mien::jsonDifference(from, to), back = mien::jsonDifference(to, from);
    EXPECT_EQ(there.empty(), from == to);
    json moved = from;
    moved.merge_patch(there);
    ASSERT_EQ(moved, to) << from << there;
    moved.merge_patch(back);
    ASSERT_EQ(moved, from) << to << back;
  }
}

}  // namespace
