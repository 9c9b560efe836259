#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "Arguments.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "CsvText.h"
#include "Failure.h"
#include "LandmarkTable.h"
#include "OutputFile.h"
#include "PictureFit.h"
#include "PolyDataFile.h"
#include "ReferenceFace.h"
#include "TextFileReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

struct AdaptCommandOptions {
  std::string picture, output, scale;
  bool yDown = false, yUp = false, symmetric = false, keepTilt = false, report = false, json = false;
};

FaceLandmarks readPicture(const std::string& name) {
  constexpr std::size_t largest = 1 << 20;  // bytes
  std::string text;
  FaceLandmarks landmarks;
  std::string fault = readTextFile(name, largest, text, "CSV file with 68 landmarks");
  if (fault.empty()) fault = parsePictureLandmarks(text, landmarks);
  if (!fault.empty()) throw FileFailure(name + ":" + fault);
  return landmarks;
}

PictureSettings settingsOf(const AdaptCommandOptions& options) {
  PictureSettings settings;
  using Vertical = PictureSettings::Vertical;
  settings.y = options.yDown ? Vertical::Down : options.yUp ? Vertical::Up : Vertical::Recognised;
  settings.symmetric = options.symmetric;
  settings.upright = !options.keepTilt;
  if (!options.scale.empty()) {
    settings.millimetres = parseNumber("--scale", options.scale);
    if (!(settings.millimetres > 0.0))
      throw ValueFailure("--scale " + options.scale + " is not allowed; it is the number of mm in one pixel, above 0");
  }
  return settings;
}

/// A face from the front misses the generic one's proportions by 0.025, one that is turned by 30 degrees by 0.14.
constexpr double mostMisfit = 0.08;  // eye distances

void remarkMisfit(const AdaptCommandOptions& options, const PictureReport& report) {
  if (report.misfit > mostMisfit)
    std::cerr << "mien: " << options.picture << ": the face seems to be turned: its landmarks lie "
              << shortestText(std::round(1000.0 * report.misfit) / 1000.0)
              << " eye distances beside a frontal face's; only a face from the front gives its true shape\n";
}

void deliver(const AdaptCommandOptions& options, const PictureReport& report) {
  remarkMisfit(options, report);
  const double tilt = report.tilt * 180.0 / M_PI;
  if (options.json)
    std::cout << nlohmann::ordered_json{{"picture", options.picture},
                                        {"y_down", report.yDown},
                                        {"mm_per_pixel", report.millimetres},
                                        {"tilt_degrees", tilt},
                                        {"misfit_eye_distances", report.misfit},
                                        {"residual_rms_mm", report.residual}}
                     .dump(2)
              << "\n";
  else if (options.report)
    std::printf(
        "%s\n  y          grows %s in the picture\n  scale      %.4f mm per pixel\n  tilt       %.1f degrees\n  misfit "
        "    %.3f eye distances RMS before the warp\n"
        "  residual   %.4f mm RMS after it\n",
        options.picture.c_str(), report.yDown ? "downwards" : "upwards", report.millimetres, tilt, report.misfit,
        report.residual);
}

void run(const AdaptCommandOptions& options) {
  requireEnding(options.output, {"vtp"});
  const PictureSettings settings = settingsOf(options);
  FaceCurves face;
  PictureReport report;
  const std::string fault =
      fitToPicture(referenceFace(), referenceLandmarks(), readPicture(options.picture), settings, face, report);
  if (!fault.empty()) throw FileFailure(options.picture + ": " + fault);
  vtkNew<vtkPolyData> data;
  writeFaceCurves(face, data);
  writePolyData(data, options.output);
  deliver(options, report);
}

}  // namespace

void addAdaptCommand(CLI::App& program) {
  const auto options = std::make_shared<AdaptCommandOptions>();
  CLI::App* command =
      program.add_subcommand("adapt", "Fit the generic face to the 68 landmarks of a frontal photograph");
  command
      ->add_option("picture", options->picture,
                   "68 landmarks, FILE.csv with the columns landmark,x,y (pixels), or x,y in their order; a header is "
                   "needed only for another order of columns")
      ->required();
  CLI::Option* down = command->add_flag("--y-down", options->yDown, "y grows downwards [recognised]");
  command->add_flag("--y-up", options->yUp, "y grows upwards")->excludes(down);
  command->add_option("--scale", options->scale, "Millimetres in one pixel [the generic face's size]");
  command->add_flag("--symmetric", options->symmetric, "Both sides of the face are averaged");
  command->add_flag("--keep-tilt", options->keepTilt, "A head that leans in the picture stays so");
  command->add_flag("--report", options->report, "Print scale, tilt and residuals");
  command->add_flag("--json", options->json, "The report as JSON");
  command->add_option("-o,--output", options->output, "File to write: .vtp")->required();
  command->footer(
      "Landmarks are numbered 0 .. 67 as in Multi-PIE: 0-16 jaw line, 17-26 brows, 27-35 nose, 36-47 eyes, 48-67 lips, "
      "from the\n"
      "subject's right, which is the left of a picture. x and y follow the picture, depth the generic face.\n"
      "Example: mien adapt anna68.csv -o anna.vtp --report");
  command->callback([options] { run(*options); });
}

}  // namespace mien
