#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
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
#include "StudyFailure.h"
#include "StudyTableRun.h"

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

StudyRun::Share shareOf(const EnsembleCommandOptions& options) {
  return {options.rank, std::max(1, options.ranks), threadsOf(options)};
}

/// Computes what is missing and appends it. @return how many cases
std::int64_t compute(StudyTableRun& opened, const EnsembleCommandOptions& options) {
  ProgressLine line;
  const StudyTableRun::Outcome outcome = opened.compute(options.output, shareOf(options), [&line](double share) {
    line.showShare(share);
    return !wasInterrupted();
  });
  if (!outcome.isComplete())
    throw Stopped("stopped after " + std::to_string(outcome.computed) + " of " + std::to_string(outcome.left) +
                  " cases; " + StudyTableRun::partOf(options.output, shareOf(options)) +
                  " keeps them, and the same command goes on from there");
  return outcome.computed;
}

/// A few cases by chance, in one thread. @return seconds for one
double secondsPerCase(StudyTableRun& opened) {
  std::mt19937_64 random(1);
  const std::int64_t blocks = opened.run().cases().blockCount();
  std::int64_t computed = 0;
  const Clock::time_point begin = Clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  StudyRun::Calls calls;
  calls.isDone = [](std::int64_t) { return false; };
  calls.append = [&](const StudyCase&, const CaseValues&) { ++computed; };
  calls.goOn = [&] { return !wasInterrupted(); };
  while (seconds() < trialSeconds && !wasInterrupted()) {
    const auto block = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(blocks));
    opened.run().run({block, blocks, 1}, calls);
  }
  if (wasInterrupted()) throw Stopped("stopped before the duration was estimated");
  return seconds() / static_cast<double>(computed);
}

void tell(const EnsembleCommandOptions& options, const json& facts, const std::string& sentence) {
  std::cout << (options.json ? facts.dump(2) : sentence) << "\n";
}

void tryOut(StudyTableRun& opened, const EnsembleCommandOptions& options) {
  const std::int64_t count = opened.caseCount(), left = opened.leftOf(shareOf(options));
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

void tellOfShare(const StudyTableRun& opened, const EnsembleCommandOptions& options, std::int64_t computed) {
  const std::string part = StudyTableRun::partOf(options.output, shareOf(options));
  tell(options, {{"part", part}, {"computed", computed}, {"study_complete", opened.isComplete()}},
       part + ": " + std::to_string(computed) + " cases computed now; " +
           (opened.isComplete() ? "all ranks are done: --join makes the table" : "other ranks are not done yet"));
}

/// The finished table, from all that ranks and earlier runs have done.
void finish(const StudyTableRun& opened, const EnsembleCommandOptions& options, std::int64_t computed) {
  const std::int64_t count = opened.caseCount();
  if (!opened.isComplete())
    throw FileFailure(options.output + ": " + std::to_string(opened.missing()) + " of " + std::to_string(count) +
                      " cases are in no part beside it; run their ranks, or the command without --join");
  opened.writeTable(options.output);
  tell(options, {{"table", options.output}, {"cases", count}, {"computed", computed}},
       options.output + ": " + std::to_string(count) + " cases, " + std::to_string(computed) + " computed now");
}

void run(const EnsembleCommandOptions& options) try {
  check(options);
  noteInterruptions();
  StudyTableRun opened(options.study, [] { return !wasInterrupted(); });
  if (wasInterrupted()) throw Stopped("stopped before the faces of the study were read; nothing was written");
  opened.readDone(options.output);
  if (options.dryRun) return tryOut(opened, options);
  const std::int64_t computed = options.join || opened.isComplete() ? 0 : compute(opened, options);
  if (options.isShared()) return tellOfShare(opened, options, computed);
  finish(opened, options, computed);
} catch (const StudyFailure& failure) {
  throw FileFailure(failure.what());
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
