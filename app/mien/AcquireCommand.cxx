#include "Acquire.h"
#include "Command.h"
#include "Failure.h"
#include "OutputFile.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace mien {

namespace {

constexpr int smallestCurve = 8, largestCurve = 4096;  // points

void check(const AcquireOptions& options) {
  requireEnding(options.outputFile, {"vtp"});
  if (options.scans.size() > 1 && !options.mean)
    throw ValueFailure("several scans make one face only as their mean; add --mean, or give one scan");
  const int k = options.pointsPerCurve;
  if (k < smallestCurve || k > largestCurve || k % 2 != 0)
    throw ValueFailure("--points " + std::to_string(k) + " is not allowed; it is an even number from " +
                       std::to_string(smallestCurve) + " to " + std::to_string(largestCurve));
}

void run(const AcquireOptions& given) {
  check(given);
  OutputFile file(given.outputFile);
  AcquireOptions options = given;
  options.outputFile = file.temporaryName();
  const std::string fault = acquire(options);
  if (!fault.empty()) throw FileFailure(fault);
  file.commit();
}

}  // namespace

void addAcquireCommand(CLI::App& program) {
  const auto options = std::make_shared<AcquireOptions>();
  CLI::App* command = program.add_subcommand("acquire", "Measure the boundary curves of a face from scans of heads");
  command->add_option("scans", options->scans, "Scans in mm: .ply .obj .stl .off; +x the subject's left, +z forward")->required();
  command->add_option("--landmarks", options->landmarkFile,
                      "68 landmarks, FILE.csv with the columns landmark,vertex or landmark,x,y,z; serves all scans")
      ->required();
  command->add_flag("--mean", options->mean, "The symmetric mean of all scans");
  command->add_option("--points", options->pointsPerCurve, "Points per curve, even")->capture_default_str();
  command->add_option("-o,--output", options->outputFile, "File to write: .vtp")->required();
  command->footer(
      "Example: mien acquire anna.ply --landmarks anna68.csv -o anna.vtp\n"
      "         mien acquire heads/*.ply --landmarks landmarks68.csv --mean -o mean.vtp");
  command->callback([options] { run(*options); });
}

}  // namespace mien
