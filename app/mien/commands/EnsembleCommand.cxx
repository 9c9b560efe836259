#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "Command.h"
#include "Failure.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "ProgressLine.h"
#include "StudyFiles.h"
#include "StudyRun.h"
#include "StudyTable.h"
#include "StudyText.h"
#include "TextFileReader.h"

namespace mien {

namespace {

using Clock = std::chrono::steady_clock;
using json = nlohmann::ordered_json;

constexpr double trialSeconds = 2.0;  // what --dry-run computes for its estimate
constexpr int mostThreads = 1024;

struct EnsembleCommandOptions {
  std::string study, output;
  int threads = 0, rank = 0, ranks = 0;
  bool join = false, dryRun = false, json = false;

  bool isShared() const { return ranks > 0; }
};

Study readStudyFile(const std::string& name) {
  std::string text;
  std::string fault = readTextFile(name, largestStudyText, text, "study");
  if (!fault.empty()) throw FileFailure(name + ":" + fault);
  Study study;
  int line = 0;
  fault = readStudy(text, study, line);
  if (!fault.empty()) throw FileFailure(name + ":" + (line > 0 ? std::to_string(line) + ": " : " ") + fault);
  study.folder = std::filesystem::path(name).parent_path().string();
  return study;
}

int threadsOf(const EnsembleCommandOptions& options) {
  if (options.threads > 0) return options.threads;
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void check(const EnsembleCommandOptions& options) {
  if (!options.dryRun && options.output.empty()) throw ValueFailure("-o is missing; name the table, as -o table.csv");
  if (!options.output.empty()) requireEnding(options.output, {"csv"});
  if (options.join && options.isShared())
    throw ValueFailure("--join merges what all ranks have done; leave --rank out");
  if (options.isShared() && options.rank >= options.ranks)
    throw ValueFailure("--rank " + std::to_string(options.rank) + " is outside 0 .. " +
                       std::to_string(options.ranks - 1) + ", the ranks of --ranks " + std::to_string(options.ranks));
}

/// A study that is ready to run, and its table.
struct Opened {
  StudyRun run;
  std::unique_ptr<StudyTable> table;

  explicit Opened(const std::string& name) : run(readStudyFile(name)) {
    const std::string fault = run.open([] { return !wasInterrupted(); });
    if (wasInterrupted()) throw Stopped("stopped before the faces of the study were read; nothing was written");
    if (!fault.empty() && run.faultIsOfValue()) throw FileFailure(name + ": " + fault);
    if (!fault.empty()) throw FileFailure(fault);
    table = std::make_unique<StudyTable>(run.study(), run.cases(), run.contents());
  }
};

std::int64_t blocksOf(const Opened& opened, const EnsembleCommandOptions& options) {
  const std::int64_t ranks = std::max(1, options.ranks);
  return (opened.run.cases().blockCount() - options.rank + ranks - 1) / ranks;
}

/// How many cases of this command's share are still to do.
std::int64_t casesLeft(const Opened& opened, const EnsembleCommandOptions& options, const StudyRows& done) {
  std::int64_t left = 0;
  for (std::int64_t i = 0; i < blocksOf(opened, options); ++i) {
    const StudyBlock block = opened.run.cases().block(options.rank + i * std::max(1, options.ranks));
    for (std::int64_t number = block.first; number < block.last; ++number) left += !done.has(number);
  }
  return left;
}

/// Computes what is missing and appends it. @return how many cases
std::int64_t compute(Opened& opened, const EnsembleCommandOptions& options, StudyRows& done) {
  PartFile part(options.isShared() ? rankPartName(options.output, options.rank) : partName(options.output),
                *opened.table);
  done.readAll(options.output);  // again: what came before the part was ours alone
  const std::int64_t left = casesLeft(opened, options, done);
  std::atomic<std::int64_t> computed{0};
  ProgressLine line;
  StudyRun::Calls calls;
  calls.isDone = [&](std::int64_t number) { return done.has(number); };
  calls.append = [&](const StudyCase& one, const CaseValues& measured) {
    part.append(opened.table->row(one, measured));
    ++computed;
  };
  calls.goOn = [&] {
    line.showShare(left > 0 ? static_cast<double>(computed) / static_cast<double>(left) : 1.0);
    return !wasInterrupted();
  };
  const bool complete =
      left == 0 || opened.run.run({options.rank, std::max(1, options.ranks), threadsOf(options)}, calls);
  if (!complete && computed < left)
    throw Stopped("stopped after " + std::to_string(computed) + " of " + std::to_string(left) + " cases; " +
                  part.name() + " keeps them, and the same command goes on from there");
  return computed;
}

/// A few cases by chance, in one thread. @return seconds for one
double secondsPerCase(Opened& opened) {
  std::mt19937_64 random(1);
  const std::int64_t blocks = opened.run.cases().blockCount();
  std::int64_t computed = 0;
  const Clock::time_point begin = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  StudyRun::Calls calls;
  calls.isDone = [](std::int64_t) { return false; };
  calls.append = [&](const StudyCase&, const CaseValues&) { ++computed; };
  calls.goOn = [&] { return !wasInterrupted(); };
  while (seconds() < trialSeconds && !wasInterrupted()) {
    const auto block = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(blocks));
    opened.run.run({block, blocks, 1}, calls);
  }
  if (wasInterrupted()) throw Stopped("stopped before the duration was estimated");
  return seconds() / static_cast<double>(computed);
}

void tell(const EnsembleCommandOptions& options, const json& facts, const std::string& sentence) {
  std::cout << (options.json ? facts.dump(2) : sentence) << "\n";
}

void tryOut(Opened& opened, const EnsembleCommandOptions& options, const StudyRows& done) {
  const std::int64_t count = opened.run.cases().count(), left = casesLeft(opened, options, done);
  const double each = secondsPerCase(opened);
  const double whole = each * static_cast<double>(left) / threadsOf(options);
  tell(options,
       {{"cases", count},
        {"left", left},
        {"threads", threadsOf(options)},
        {"seconds_per_case", each},
        {"seconds", whole}},
       std::to_string(count) + " cases, " + std::to_string(left) + " to compute: about " +
           ProgressLine::readableTime(whole) + " in " + std::to_string(threadsOf(options)) + " threads");
}

/// The finished table, from all that ranks and earlier runs have done.
void finish(const Opened& opened, const EnsembleCommandOptions& options, const StudyRows& done, std::int64_t computed) {
  const std::int64_t count = opened.run.cases().count();
  done.writeTable(options.output, opened.table->head());
  tell(options, {{"table", options.output}, {"cases", count}, {"computed", computed}},
       options.output + ": " + std::to_string(count) + " cases, " + std::to_string(computed) + " computed now");
}

void run(const EnsembleCommandOptions& options) {
  check(options);
  noteInterruptions();
  Opened opened(options.study);
  StudyRows done(*opened.table, opened.run.cases().count());
  if (!options.output.empty()) done.readAll(options.output);
  if (options.dryRun) return tryOut(opened, options, done);
  const std::int64_t computed = options.join || done.isComplete() ? 0 : compute(opened, options, done);
  done.readAll(options.output);
  if (options.isShared()) {
    const std::string part = rankPartName(options.output, options.rank);
    return tell(
        options, {{"part", part}, {"computed", computed}, {"study_complete", done.isComplete()}},
        part + ": " + std::to_string(computed) + " cases computed now; " +
            (done.isComplete() ? "all ranks are done: --join makes the table" : "other ranks are not done yet"));
  }
  if (!done.isComplete())
    throw FileFailure(options.output + ": " + std::to_string(done.missing()) + " of " +
                      std::to_string(opened.run.cases().count()) +
                      " cases are in no part beside it; run their ranks, or the command without --join");
  finish(opened, options, done, computed);
}

}  // namespace

void addEnsembleCommand(CLI::App& program) {
  const auto options = std::make_shared<EnsembleCommandOptions>();
  CLI::App* command = program.add_subcommand("ensemble", "Measure every case of a study in one table");
  command->add_option("study", options->study, "Faces, schemes, a, N, expressions, frames and measures: STUDY.json")
      ->required();
  command->add_option("-o,--output", options->output, "The table: TABLE.csv, one row for each case");
  command->add_option("--threads", options->threads, "How many cases are computed at once [one for each processor]")
      ->check(CLI::Range(1, mostThreads));
  CLI::Option* ranks = command->add_option("--ranks", options->ranks, "How many programs share the study")
                           ->check(CLI::Range(1, 1000000));
  command->add_option("--rank", options->rank, "Which of them this is, from 0: its rows go to TABLE.csv.rank0.part")
      ->check(CLI::Range(0, 999999))
      ->needs(ranks);
  command->add_flag("--join", options->join, "Compute nothing: merge what all ranks have done");
  command->add_flag("--dry-run", options->dryRun, "Only tell how many cases there are and about how long they take");
  command->add_flag("--json", options->json, "Machine-readable results");
  command->footer(
      "Example: mien ensemble study.json -o table.csv\n"
      "         mien ensemble study.json -o table.csv --rank 2 --ranks 8 && mien ensemble study.json -o table.csv "
      "--join\n"
      "A study is {\"mien_study\": 1, \"faces\": [\"generic\", \"anna.vtp\"], \"schemes\": \"all\", \"a\": "
      "\"0.1:10:21log\", \"harmonics\": [5, 8],\n"
      "\"expressions\": [\"neutral\", \"joy:0.8\"], \"measures\": [\"area_mm2\", \"motion_rms_mm\"]}. Rows are kept in "
      "TABLE.csv.part as they come:\n"
      "after Ctrl-C, a crash or a power cut the same command goes on from there. The finished table has the same bytes "
      "whatever happened.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
