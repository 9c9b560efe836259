#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "AnimationData.h"
#include "AnimationText.h"
#include "AnimationTextFile.h"
#include "Arguments.h"
#include "CaptureWriter.h"
#include "Command.h"
#include "Counted.h"
#include "CsvText.h"
#include "FAPCsvWriter.h"
#include "FAPList.h"
#include "FAPParser.h"
#include "FAPTable.h"
#include "FAPWriter.h"
#include "Failure.h"
#include "FrameTimes.h"
#include "HighLevelFAPs.h"
#include "NumberText.h"
#include "OutputFile.h"
#include "TimeCode.h"

namespace mien {

namespace {

constexpr double roundedTo = 1e6;       // parts of a FAP unit, of values that were computed
constexpr double largestRounded = 1e9;  // larger values have no digits to lose

struct ConvertCommandOptions {
  std::string input, output, from, to, fps, map, start;
};

struct Target {
  const char* name;
  std::optional<CaptureStyle> capture;
};

const std::pair<const char*, AnimationFormat> sources[] = {{"fap", AnimationFormat::FAP},
                                                           {"fap-csv", AnimationFormat::FAPCsv},
                                                           {"facs", AnimationFormat::ActionUnits},
                                                           {"openface", AnimationFormat::ActionUnits},
                                                           {"arkit", AnimationFormat::Blendshapes}};

const Target targets[] = {{"fap", {}},
                          {"fap-csv", {}},
                          {"facs", CaptureStyle::FACS},
                          {"openface", CaptureStyle::OpenFace},
                          {"arkit", CaptureStyle::LiveLinkFace}};

std::optional<AnimationFormat> chooseSource(const ConvertCommandOptions& options) {
  for (const auto& [name, format] : sources)
    if (options.from == name) return format;
  if (!options.from.empty())
    throw ValueFailure("--from '" + options.from + "' is no format; there are fap, fap-csv, facs, openface and arkit");
  return std::nullopt;
}

/// By --to, else by the ending: FAPs as they are.
Target chooseTarget(const ConvertCommandOptions& options) {
  for (const Target& target : targets)
    if (options.to == target.name) return target;
  if (!options.to.empty())
    throw ValueFailure("--to '" + options.to + "' is no format; there are fap, fap-csv, facs, openface and arkit");
  if (options.output != "-") requireEnding(options.output, {"fap", "csv"});
  return targets[fileEnding(options.output) == "csv" ? 1 : 0];
}

double chooseRate(const std::string& text) {
  const double rate = text.empty() ? 0.0 : parseNumber("--fps", text);
  if (!text.empty() && !(rate >= slowestFAPRate && rate <= fastestFAPRate))
    throw ValueFailure("--fps " + text + " is outside 0.001 .. 100000");
  return rate;
}

FacialActionMap readMap(const std::string& file) {
  FacialActionMap map;
  const std::string fault = readFacialActions(file, map);
  if (!fault.empty()) throw FileFailure(fault);
  return map;
}

bool isCapture(std::optional<AnimationFormat> format) {
  return format == AnimationFormat::ActionUnits || format == AnimationFormat::Blendshapes;
}

/// To a millionth: less is the rounding of sums and products, and makes long numbers.
void roundValues(FAPSequence& sequence) {
  const auto round = [](double value) {
    return std::abs(value) < largestRounded ? std::round(value * roundedTo) / roundedTo : value;
  };
  for (FAPFrame& frame : sequence.frames)
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) frame.setValue(fap, round(frame.value(fap)));
}

FAPSequence readInput(const ConvertCommandOptions& options, const FacialActionMap& map) {
  const std::string name = shownAnimationName(options.input);
  std::string text;
  FAPSequence sequence;
  const std::string fault = readAnimationText(options.input, text);
  if (!fault.empty()) throw FileFailure(name + ": " + fault);
  const std::optional<AnimationFormat> source = chooseSource(options);
  const auto error = parseAnimation(text, source, map, sequence);
  if (error) throw FileFailure(name + ":" + std::to_string(error->line) + ": " + error->message);
  for (const FAPWarning& warning : sequence.warnings)
    std::cerr << "mien: " << name << ":" << warning.line << ": " << warning.message << "\n";
  if (isCapture(source ? source : recogniseAnimation(text, map))) roundValues(sequence);
  return sequence;
}

/// A rate that the file does not tell is simply taken; to another one the animation is mixed.
void changeRate(double rate, FAPSequence& sequence) {
  if (rate == 0.0 || rate == sequence.framesPerSecond) return;
  if (sequence.rateIsAssumed)
    sequence.framesPerSecond = rate;
  else if (std::optional<FAPSequence> mixed = resampled(sequence, rate)) {
    sequence = std::move(*mixed);
    roundValues(sequence);
  } else
    throw ValueFailure("--fps " + shortestText(rate) + " makes more than a million frames of " +
                       shortestText(sequence.duration()) + " s; give a lower rate");
}

/// A table of FAPs and a file of Live Link Face tell when an animation began; others have no place for it.
bool keepsStart(const Target& target) {
  return target.capture ? *target.capture == CaptureStyle::LiveLinkFace : std::string(target.name) == "fap-csv";
}

std::optional<double> chooseStart(const ConvertCommandOptions& options, const Target& target) {
  if (options.start.empty()) return std::nullopt;
  if (!keepsStart(target))
    throw ValueFailure(std::string("--start: the format ") + target.name +
                       " has no place for a time code; fap-csv and arkit have");
  const std::optional<TimeCode> code = parseTimeCode(options.start);
  if (!code || code->dropsNumbers || code->seconds >= 86400.0 || code->frames >= writtenTimeCodeRate)
    throw ValueFailure("--start '" + options.start +
                       "' is no time code; write HH:MM:SS:FF, 60 frames per second, or "
                       "HH:MM:SS.sss");
  return secondsOf(*code, writtenTimeCodeRate);
}

void tellLostStart(const FAPSequence& sequence, const Target& target, const std::string& output) {
  if (sequence.startTime > 0.0 && !keepsStart(target))
    std::cerr << "mien: " << output << ": the time code of the first frame, " << timeCodeText(sequence.startTime)
              << ", has no place in this format; a table of FAPs keeps it, and --start gives it back\n";
}

void resolveShapes(FAPSequence& sequence) {
  for (FAPFrame& frame : sequence.frames) resolveHighLevelFAPs(defaultVisemes(), defaultExpressions(), frame);
  for (FAPMask& mask : sequence.masks) mask[0] = mask[1] = false;
}

void tellLoss(const CaptureLoss& loss, const std::string& output) {
  if (!loss.faps.empty())
    std::cerr << "mien: " << output << ": there is no column for these FAPs, they are lost: " << listOfFAPs(loss.faps)
              << "\n";
  const long percent = std::lround(100.0 * loss.share);
  if (percent > 0)
    std::cerr << "mien: " << output << ": the columns come near the FAPs only; " << percent
              << " % of the movement is lost (root mean square), most in frame " << shortestText(loss.worstFrame)
              << "\n";
}

std::string textOf(FAPSequence sequence, const Target& target, const FacialActionMap& map, const std::string& output) {
  std::string text, fault;
  if (target.capture) {
    resolveShapes(sequence);
    CaptureLoss loss;
    fault = writeCapture(sequence, *target.capture, map, text, loss);
    tellLoss(loss, output);
  } else {
    fault = std::string(target.name) == "fap" ? writeFAP(sequence, text) : writeFAPCsv(sequence, text);
  }
  if (!fault.empty()) throw FileFailure(output + ": " + fault);
  return text;
}

void run(const ConvertCommandOptions& options) {
  const Target target = chooseTarget(options);
  const double rate = chooseRate(options.fps);
  const std::optional<double> start = chooseStart(options, target);
  const FacialActionMap map = readMap(options.map);
  FAPSequence sequence = readInput(options, map);
  changeRate(rate, sequence);
  sequence.startTime = start.value_or(sequence.startTime);
  if (sequence.name.empty() && options.input != "-")
    sequence.name = options.input.substr(options.input.find_last_of('/') + 1);
  const std::string output = options.output == "-" ? "standard output" : options.output;
  const std::string text = textOf(sequence, target, map, output);
  tellLostStart(sequence, target, output);
  if (options.output == "-") {
    std::cout << text;
    return;
  }
  OutputFile::write(options.output, text);
  std::cout << counted(sequence.frames.size(), "frame") << " at "
            << shortestText(std::round(sequence.framesPerSecond * 1e3) / 1e3) << " per second in " << options.output
            << "\n";
}

}  // namespace

void addConvertCommand(CLI::App& program) {
  const auto options = std::make_shared<ConvertCommandOptions>();
  CLI::App* command =
      program.add_subcommand("convert", "Turn animations into each other: .fap, tables of FAPs, FACS, ARKit");
  command->add_option("input", options->input, "FILE.fap or FILE.csv; - is standard input")->required();
  command->add_option("-o,--output", options->output, "FILE.fap or FILE.csv; - is standard output")->required();
  command->add_option("--from", options->from,
                      "What the input is: fap fap-csv facs openface arkit [as its header says]");
  command->add_option("--to", options->to, "What to write: fap fap-csv facs openface arkit [.fap: fap, .csv: fap-csv]");
  command->add_option(
      "--fps", options->fps,
      "Frames per second to write, mixed from those around; of an input without time its own rate [the input's]");
  command->add_option("--start", options->start,
                      "Time code of the first frame, HH:MM:SS:FF at 60 per second, for arkit and fap-csv [the input's, "
                      "or 0]");
  command->add_option("--map", options->map,
                      "What action units and blendshapes move, FILE.json [data/animation/facs_map.json]");
  command->footer(
      "Example: mien convert take.csv -o take.fap                 Live Link Face or OpenFace, seen from the header\n"
      "         mien convert speech.fap -o speech.csv             a table of FAPs, for a spreadsheet or NumPy\n"
      "         mien convert speech.fap --to arkit -o speech.csv  the nearest blendshapes; says what is lost\n"
      "         mien convert speech.fap --to arkit --start 10:59:58:13 -o speech.csv\n"
      "         mien convert take.csv --fps 25 -o - | mien animate - -o frames/");
  command->callback([options] { run(*options); });
}

}  // namespace mien
