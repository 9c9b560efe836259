#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "DepthMovement.h"
#include "FaceFrame.h"
#include "FaceMotion.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "FdtCommands.h"
#include "FittedTable.h"
#include "Remarks.h"
#include "TableOutput.h"
#include "TableRecognition.h"
#include "TableRows.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

// Fine enough that each region has hundreds of points, on rows that all lie on curves or between them.
constexpr int defaultRows = 164, defaultColumns = 160;

struct FdtFromFapCommandOptions {
  std::string expressions;
  FaceOptions face;
  MarkerFileOptions reading;
  TableOutput output;
};

bool movesAnything(const FaceState& state) {
  return state != FaceMotion::neutralOf(state);
}

vtkSmartPointer<vtkStructuredGrid> copyOf(vtkStructuredGrid* grid) {
  const auto copy = vtkSmartPointer<vtkStructuredGrid>::New();
  copy->DeepCopy(grid);
  return copy;
}

/// Of the movement in depth, which no table carries.
struct Depths {
  DepthMovement movement;
  double unit;  ///< half the distance between the pupils, mm
};

FaceFrame frameOf(vtkStructuredGrid* grid, const FacialRegions& regions) {
  FaceFrame frame;
  const std::string fault = readFaceFrame(grid, {}, regions, frame);
  if (!fault.empty()) throw FileFailure(fault);
  return frame;
}

Depths depthsBetween(vtkStructuredGrid* neutral, vtkStructuredGrid* moved, const FacialRegions& regions) {
  const FaceFrame before = frameOf(neutral, regions), after = frameOf(moved, regions);
  return {DepthMovement({before.points, before.pupils}, {after.points, after.pupils}, regions), before.pupils.unit()};
}

Report reportOf(const FittedTable& fitted, const Depths& depths, const FacialRegions& regions) {
  Report report;
  report.json = fitted.description(regions);
  report.json["rms_mm"] = depths.unit * fitted.rms;
  report.json["depth_mm"] = depths.unit * depths.movement.all;
  report.rows = json::array();
  for (int region = 1; region <= FacialRegions::count; ++region) {
    json& about = report.json["regions"][region - 1];
    about["rms_mm"] = depths.unit * fitted.regions[region - 1].rms;
    about["depth_mm"] = depths.unit * depths.movement.regions[region - 1];
    report.rows.push_back({{"region", std::to_string(region) + " " + regions.name(region)},
                           {"points", about["points"]},
                           {"rms", about["rms"]},
                           {"rms_mm", about["rms_mm"]},
                           {"depth_mm", about["depth_mm"]}});
  }
  report.remarks = {"RMS " + readableNumber(fitted.rms) + " pupil units, " + readableNumber(depths.unit * fitted.rms) +
                    " mm; depth_mm is the movement in depth (RMS " + readableNumber(depths.unit * depths.movement.all) +
                    " mm), which no table carries"};
  return report;
}

void run(FdtFromFapCommandOptions& options) {
  options.output.check();
  const FacialRegions regions = options.reading.regions();
  if (!options.expressions.empty()) options.face.setExpressions(options.expressions);
  FaceState state = options.face.state();
  if (!movesAnything(state))
    throw ValueFailure("nothing moves the face; name an expression such as joy, or give --fap FILE --frame K or --set");
  FacePipeline pipeline;
  options.face.apply(pipeline);
  updateOrThrow(pipeline);
  printRemarks(pipeline);
  const auto moved = copyOf(pipeline.grid());
  pipeline.setState(FaceMotion::neutralOf(pipeline.state()));
  updateOrThrow(pipeline);
  const auto neutral = copyOf(pipeline.grid());
  const std::string face = state.curvesFile.empty() ? "generic face" : state.curvesFile;
  const FittedTable fitted = fitSurfaces(neutral, moved, options.reading, "", false, face);
  if (!fitted.warning.empty()) std::cerr << "mien: " << face << ": " << fitted.warning << "\n";
  if (fitted.table.largestDisplacement < leastRecognisedMovement)
    std::cerr << "mien: the face does not move" << (state.fapFile.empty() ? "" : " in this frame")
              << ", so the table moves nothing; choose "
              << (state.fapFile.empty() ? "more intensity" : "another with --frame, --index or --time") << "\n";
  std::string what = state.fapFile;
  for (const auto& [name, strength] : state.visemes)
    what += (what.empty() ? "viseme " : ", viseme ") + name + ":" + readableNumber(strength);
  for (const auto& [name, intensity] : state.expressions)
    what += (what.empty() ? "" : ", ") + name + ":" + readableNumber(intensity);
  options.output.write(fitted.table, "Fitted to " + (what.empty() ? "FAPs" : what) + " of the " + face + ", RMS " +
                                         readableNumber(fitted.rms) + " pupil units; Mien " MIEN_VERSION);
  options.output.print(reportOf(fitted, depthsBetween(neutral, moved, regions), regions));
}

}  // namespace

void addFdtFromFapCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtFromFapCommandOptions>();
  CLI::App* command = parent.add_subcommand("from-fap", "Fit a table to a FAP expression or frame of the PDE face");
  CLI::Option* expressions = command->add_option(
      "expressions", options->expressions, "Expressions with intensities, such as joy:0.8 or joy:0.6,surprise:0.4");
  options->output.addTo(*command, "Table to write, FILE.csv");
  options->face.setDefaultResolution(defaultRows, defaultColumns);
  options->face.addAll(*command);
  options->reading.addRegionsTo(*command);
  expressions->excludes(command->get_option("--expression"));
  command->footer(
      "Example: mien fdt from-fap joy -o joy.csv && mien fdt apply joy.csv head.ply --landmarks head68.csv -o "
      "smiling.ply\n"
      "         mien fdt from-fap --fap talk.fap --frame 12 -o frame.csv\n"
      "The face is sampled at 164 x 160 unless --resolution says otherwise; lips and lids are told apart by u.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
