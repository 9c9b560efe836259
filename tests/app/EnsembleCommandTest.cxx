#include <gtest/gtest.h>
#include <signal.h>
#include <sys/file.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "Program.h"

namespace {

using json = nlohmann::json;

const char* const smallStudy =
    "{\"mien_study\": 1, \"schemes\": [\"four-curve\", \"spline\"], \"a\": \"0.1:3:12log\", \"harmonics\": [4, 30],"
    "\"expressions\": [\"neutral\", \"joy\", \"surprise:0.5,joy:0.2\"], \"resolution\": [38, 20]}";

struct Ensemble {
  TemporaryFolder folder;
  std::string study = folder.file("study.json"), table = folder.file("table.csv");
  std::string part = table + ".part";

  explicit Ensemble(const std::string& text = smallStudy) { writeTextFile(study, text); }
  Outcome run(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"ensemble", study, "-o", table, "--json"});
    return runMien(more);
  }
  json facts(const std::vector<std::string>& more = {}) const {
    const Outcome outcome = run(more);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return json::parse(outcome.output, nullptr, false);
  }
  std::string bytes() const { return readTextFile(table); }
};

std::string smallTable() {
  static const std::string bytes = [] {
    const Ensemble ensemble;
    EXPECT_EQ(ensemble.facts({"--threads", "1"}).value("computed", 0), 2 * 12 * 2 * 3);
    return ensemble.bytes();
  }();
  return bytes;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The cells of a row by the names of their columns, as they stand there; no cell of these tests has a comma.
using Row = std::map<std::string, std::string>;
std::vector<Row> rowsOf(const std::string& csv) {
  std::vector<Row> rows;
  std::vector<std::string> names;
  for (const std::string& line : linesOf(csv)) {
    if (line[0] == '#') continue;
    std::vector<std::string> cells(1);
    for (const char c : line)
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    if (names.empty()) {
      names = cells;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i) rows.back()[names[i]] = cells[i];
  }
  return rows;
}

TEST(EnsembleCommand, HasTheNumbersOfSweepContinuityAndSpectrumToTheBit) {
  const Ensemble ensemble(
      "{\"mien_study\": 1, \"schemes\": [\"tangent\", \"spline\"], \"a\": [0.5, 2], \"harmonics\": [6],"
      "\"expressions\": [\"joy:0.7\"], \"resolution\": [56, 40]}");
  ensemble.facts();
  const std::vector<Row> rows = rowsOf(ensemble.bytes());
  ASSERT_EQ(rows.size(), 4u);
  const std::vector<std::string> face = {"-N", "6", "--expression", "joy:0.7", "--resolution", "56x40"};
  const auto tableOf = [&](std::vector<std::string> command) {
    const std::string file = ensemble.folder.file(command[0] + ".csv");
    command.insert(command.end(), face.begin(), face.end());
    command.insert(command.end(), {"-o", file});
    EXPECT_EQ(runMien(command).exitCode, 0) << command[0];
    return rowsOf(readTextFile(file));
  };
  const std::vector<Row> swept = tableOf({"sweep", "--scheme", "tangent,spline", "--a", "0.5,2"});
  ASSERT_EQ(swept.size(), 4u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_GE(swept[i].size(), 13u);
    for (const auto& [name, cell] : swept[i]) EXPECT_EQ(rows[i].at(name), cell) << name;
    const std::string scheme = rows[i].at("scheme"), a = rows[i].at("a");
    for (Row seam : tableOf({"continuity", "--scheme", scheme, "-a", a})) {
      if (seam["seam"] != "all") continue;
      for (const char* const name : {"g0_max_mm", "g1_mean_deg", "g1_max_deg", "c1_max", "g2_max_per_mm", "c2_max"}) {
        EXPECT_EQ(rows[i].at(std::string("seam_") + name), seam.at(name)) << name;
        EXPECT_EQ(rows[i].at(std::string("frontal_seam_") + name), seam.at(std::string("frontal_") + name)) << name;
      }
    }
    for (Row mode : tableOf({"spectrum", "--scheme", scheme, "-a", a})) {
      if (mode["mode"] == "1") {
        EXPECT_EQ(rows[i].at("mode1_energy_share"), mode.at("energy_share"));
      }
      if (mode["mode"] == "6") {
        EXPECT_EQ(rows[i].at("remainder_rms_mm"), mode.at("cumulative_rms_error_mm"));
      }
    }
  }
}

/// Points of a table of a surface in double precision, rows and columns as they come.
std::vector<std::array<double, 3>> pointsOf(const Ensemble& ensemble, std::vector<std::string> face) {
  const std::string file = ensemble.folder.file("surface.csv");
  face.insert(face.begin(), {"surface", "--resolution", "83x40", "--precision", "double", "-a", "1.5", "-o", file});
  EXPECT_EQ(runMien(face).exitCode, 0);
  std::vector<std::array<double, 3>> points;
  for (const Row& row : rowsOf(readTextFile(file)))
    points.push_back({std::stod(row.at("x")), std::stod(row.at("y")), std::stod(row.at("z"))});
  return points;
}

TEST(EnsembleCommand, MotionOfAFrameIsWhatTheSurfacesSay) {
  const std::string demo = MIEN_DATA_DIR "/animation/demo.fap";
  const Ensemble ensemble("{\"mien_study\": 1, \"fap\": {\"file\": \"" + demo +
                          "\", \"frames\": [150]}, \"expressions\": [\"neutral\"], \"a\": 1.5, \"resolution\": [83, "
                          "40], \"measures\": [\"motion_max_mm\"]}");
  ensemble.facts();
  const std::vector<Row> rows = rowsOf(ensemble.bytes());
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].at("motion_max_mm"), "0");
  EXPECT_EQ(rows[1].at("frame"), "150");
  const auto moved = pointsOf(ensemble, {"--fap", demo, "--frame", "150"}), neutral = pointsOf(ensemble, {});
  ASSERT_EQ(moved.size(), neutral.size());
  ASSERT_GT(moved.size(), 3000u);
  double largest = 0.0;
  for (std::size_t i = 0; i < moved.size(); ++i)
    largest = std::max(
        largest, std::hypot(moved[i][0] - neutral[i][0], moved[i][1] - neutral[i][1], moved[i][2] - neutral[i][2]));
  EXPECT_GT(largest, 0.5);
  EXPECT_NEAR(std::stod(rows[1].at("motion_max_mm")), largest, 1e-9);
}

TEST(EnsembleCommand, HasTheSameBytesForAnyNumberOfThreadsAndRanks) {
  for (const char* const threads : {"2", "5"}) {
    const Ensemble ensemble;
    ensemble.facts({"--threads", threads});
    EXPECT_EQ(ensemble.bytes(), smallTable());
    EXPECT_EQ(entriesIn(ensemble.folder.file("")), 2) << "no part is left";
    EXPECT_EQ(ensemble.facts().value("computed", -1), 0) << "a finished table is not computed again";
    EXPECT_EQ(ensemble.bytes(), smallTable());
  }
  const Ensemble ensemble;
  int computed = 0;
  for (const char* const rank : {"2", "0"})
    computed += ensemble.facts({"--ranks", "3", "--rank", rank}).value("computed", 0);
  const Outcome early = ensemble.run({"--join"});
  EXPECT_EQ(early.exitCode, 1);
  EXPECT_NE(early.errors.find(std::to_string(144 - computed) + " of 144 cases"), std::string::npos) << early.errors;
  EXPECT_FALSE(std::filesystem::exists(ensemble.table));
  computed += ensemble.facts({"--ranks", "3", "--rank", "1"}).value("computed", 0);
  EXPECT_EQ(computed, 144);
  EXPECT_EQ(ensemble.facts({"--join"}).value("computed", -1), 0);
  EXPECT_EQ(ensemble.bytes(), smallTable());
  EXPECT_EQ(entriesIn(ensemble.folder.file("")), 2);
}

/// Starts the command and sends it a signal after some time. @return how it ended: its exit code, or minus the signal
int stopped(const Ensemble& ensemble, int signal, int milliseconds) {
  std::vector<std::string> words = {MIEN_PROGRAM, "ensemble", ensemble.study, "-o", ensemble.table, "--threads", "2"};
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return -1;
  usleep(1000 * milliseconds);
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Whole rows of the part, and that none is there twice.
std::size_t rowsKept(const Ensemble& ensemble) {
  const std::string text = readTextFile(ensemble.part);
  std::vector<std::string> numbers;
  for (const std::string& line : linesOf(text.substr(0, text.rfind('\n') + 1)))
    if (!line.empty() && std::isdigit(static_cast<unsigned char>(line[0])))
      numbers.push_back(line.substr(0, line.find(',')));
  std::sort(numbers.begin(), numbers.end());
  EXPECT_EQ(std::adjacent_find(numbers.begin(), numbers.end()), numbers.end()) << "a case was computed twice";
  return numbers.size();
}

TEST(EnsembleCommand, KilledAtAnyMomentLosesNothingAndComputesNothingTwice) {
  std::mt19937 random(11);
  std::size_t kept = 0;
  int kills = 0;
  const Ensemble ensemble;
  for (; kills < 40 && !std::filesystem::exists(ensemble.table); ++kills) {
    stopped(ensemble, SIGKILL, static_cast<int>(30 + random() % 200));
    if (std::filesystem::exists(ensemble.table)) break;
    const std::size_t now = rowsKept(ensemble);
    EXPECT_GE(now, kept) << "rows were lost";
    kept = now;
  }
  EXPECT_GE(kills, 2);
  const bool ended = std::filesystem::exists(ensemble.table);
  const json facts = ensemble.facts();
  EXPECT_EQ(facts.value("computed", -1), ended ? 0 : static_cast<int>(144 - kept));
  EXPECT_EQ(ensemble.bytes(), smallTable());
  EXPECT_EQ(std::filesystem::exists(ensemble.part), false);
}

TEST(EnsembleCommand, AnInterruptionKeepsWhatIsDoneAndSaysSo) {
  const Ensemble ensemble(std::string(smallStudy).replace(std::string(smallStudy).find("[38, 20]"), 8, "[112, 80]"));
  EXPECT_EQ(stopped(ensemble, SIGINT, 700), 130);
  const std::size_t kept = rowsKept(ensemble);
  EXPECT_LT(kept, 144u);
  EXPECT_FALSE(std::filesystem::exists(ensemble.table));
  EXPECT_EQ(ensemble.facts().value("computed", -1), static_cast<int>(144 - kept));
}

TEST(EnsembleCommand, TornAndForeignLinesAreComputedAgain) {
  const Ensemble ensemble;
  const std::vector<std::string> lines = linesOf(smallTable());
  std::string text;
  for (std::size_t i = 0; i < 100; ++i) text += lines[i] + "\n";
  text += "\n" + std::string(50, '\0') + "\n" + lines[120].substr(0, 40) + "\n" + lines[110] + "\n" + lines[110] + "\n";
  text += lines[111].substr(0, 60);
  writeTextFile(ensemble.part, text);
  EXPECT_EQ(ensemble.facts().value("computed", -1), 144 - 98 - 1);
  EXPECT_EQ(ensemble.bytes(), smallTable());
  writeTextFile(ensemble.part, smallTable().substr(0, 33));  // torn in its first line
  std::filesystem::remove(ensemble.table);
  EXPECT_EQ(ensemble.facts().value("computed", -1), 144);
  EXPECT_EQ(ensemble.bytes(), smallTable());
}

TEST(EnsembleCommand, APartOfAnotherStudyIsRefusedAndStays) {
  const Ensemble ensemble("{\"mien_study\": 1, \"faces\": [\"anna.vtp\"], \"resolution\": [38, 20]}");
  const std::string face = ensemble.folder.file("anna.vtp");
  ASSERT_EQ(runMien({"curves", "-o", face}).exitCode, 0);
  ensemble.facts();
  const std::string bytes = ensemble.bytes();
  std::filesystem::rename(ensemble.table, ensemble.part);
  EXPECT_EQ(ensemble.facts().value("computed", -1), 0);
  EXPECT_EQ(ensemble.bytes(), bytes);
  std::filesystem::rename(ensemble.table, ensemble.part);
  ASSERT_EQ(runMien({"curves", "--expression", "joy", "-o", face}).exitCode, 0);  // another anna
  const Outcome outcome = ensemble.run();
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.errors.find(ensemble.part + ": it holds rows of another study"), std::string::npos)
      << outcome.errors;
  EXPECT_EQ(readTextFile(ensemble.part), bytes);
  EXPECT_FALSE(std::filesystem::exists(ensemble.table));
}

TEST(EnsembleCommand, TwoProgramsDoNotWriteOnePart) {
  const Ensemble ensemble;
  const int part = open(ensemble.part.c_str(), O_WRONLY | O_CREAT, 0600);
  ASSERT_EQ(flock(part, LOCK_EX), 0);
  const Outcome outcome = ensemble.run();
  close(part);
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.errors.find("another mien"), std::string::npos) << outcome.errors;
}

TEST(EnsembleCommand, ADryRunWritesNothing) {
  const Ensemble ensemble;
  const json facts = ensemble.facts({"--dry-run", "--threads", "2"});
  EXPECT_EQ(facts.value("cases", 0), 144);
  EXPECT_EQ(facts.value("left", 0), 144);
  EXPECT_GT(facts.value("seconds", 0.0), 0.0);
  EXPECT_NEAR(facts.value("seconds", 0.0), facts.value("seconds_per_case", 0.0) * 144 / 2, 1e-9);
  EXPECT_EQ(entriesIn(ensemble.folder.file("")), 1);
}

TEST(EnsembleCommand, WhatIsWrongIsOneSentence) {
  const Ensemble ensemble;
  const auto complains = [&](const std::string& text, const std::string& about) {
    writeTextFile(ensemble.study, text);
    const Outcome outcome = ensemble.run();
    EXPECT_EQ(outcome.exitCode, 1) << text;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_NE(outcome.errors.find(about), std::string::npos) << outcome.errors;
    EXPECT_EQ(entriesIn(ensemble.folder.file("")), 1);
  };
  complains("{\"mien_study\": 1,\n \"a\": [1,}", ensemble.study + ":2: study: it is no valid JSON");
  complains("{\"mien_study\": 1, \"schemes\": [\"x\"]}", "'schemes': there is no scheme 'x'; there are four-curve");
  complains("{\"mien_study\": 1, \"expressions\": [\"joi\"]}", "there is no expression 'joi'");
  complains("{\"mien_study\": 1, \"faces\": [\"nobody.vtp\"]}", ensemble.folder.file("nobody.vtp"));
  complains("{\"mien_study\": 1, \"fap\": {\"file\": \"nobody.fap\"}}", ensemble.folder.file("nobody.fap"));
  complains("{\"mien_study\": 1, \"fap\": {\"file\": \"" MIEN_DATA_DIR "/animation/demo.fap\", \"frames\": [1e6]}}",
            "there is no frame with number");
  EXPECT_EQ(ensemble.run({"--rank", "0"}).exitCode, 2);
  EXPECT_EQ(ensemble.run({"--rank", "3", "--ranks", "3"}).exitCode, 2);
  EXPECT_EQ(ensemble.run({"--threads", "0"}).exitCode, 2);
  EXPECT_EQ(runMien({"ensemble", ensemble.study}).exitCode, 2);
  EXPECT_EQ(runMien({"ensemble", ensemble.study, "-o", "table.txt"}).exitCode, 2);
}

}  // namespace
