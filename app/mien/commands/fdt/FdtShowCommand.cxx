#include <CLI/CLI.hpp>
#include <memory>

#include "Arguments.h"
#include "DeformationFigure.h"
#include "DeviationText.h"
#include "FaceArrows.h"
#include "FaceLines.h"
#include "Failure.h"
#include "FdtCommands.h"
#include "ReportOptions.h"
#include "TableDeformation.h"
#include "TableInput.h"
#include "TableRows.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct FdtShowCommandOptions {
  std::string table, magnification = "1";
  bool noCoefficients = false;
  DeformationOptions deformation;
  ReportOptions report;
};

/// A row for each of the 192 coefficients: value, and standard deviation and range where the table has them.
json coefficientRows(const DeformationTable& table) {
  json rows = json::array();
  for (int i = 0; i < 12 * FacialRegions::count; ++i) {
    const int region = i / 12, row = i % 12 / 6, column = i % 6;
    const double value = table.maps[region].coefficients(row, column);
    json about = {{"region", region + 1}, {"coefficient", coefficientName(i % 12)}, {"value", value}};
    if (!table.knows(region + 1)) about["value"] = nullptr;
    if (table.deviations) {
      const double deviation = table.deviations->at(region)(row, column);
      const bool known = table.hasRange(region + 1);
      about["sd"] = known ? json(deviation) : json(nullptr);
      about["low"] = known ? json(value - deviation) : json(nullptr);
      about["high"] = known ? json(value + deviation) : json(nullptr);
    }
    rows.push_back(about);
  }
  return rows;
}

std::string readableCoefficient(const DeformationTable& table, int region, int row, int column) {
  const double value = table.maps[region].coefficients(row, column);
  if (!table.knows(region + 1)) return "-";
  return table.hasRange(region + 1) ? rangeText(value, table.deviations->at(region)(row, column), "+-")
                                    : fixedText(value);
}

/// Two rows a region, x' and y', so that a line fits a terminal.
json readableRows(const DeformationTable& table, const FacialRegions& regions) {
  json rows = json::array();
  for (int region = 0; region < FacialRegions::count; ++region)
    for (int row = 0; row < 2; ++row) {
      json line = {{"region", row ? std::string("-") : std::to_string(region + 1) + " " + regions.name(region + 1)},
                   {"to", row ? "y'" : "x'"}};
      const char* const terms[] = {"x2", "xy", "y2", "x", "y", "1"};
      for (int column = 0; column < 6; ++column) line[terms[column]] = readableCoefficient(table, region, row, column);
      rows.push_back(line);
    }
  return rows;
}

json regionList(const DeformationTable& table, const FacialRegions& regions) {
  json list = json::array();
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const Eigen::Vector2d& centre = regions.centre(region);
    const Eigen::Vector2d move = table.maps[region - 1].apply(centre) - centre;
    json about = {{"region", region}, {"name", regions.name(region)}};
    about["known"] = table.knows(region);
    if (table.counts) about["n"] = table.counts->at(region - 1);
    about["centre"] = {centre.x(), centre.y()};
    about["centre_displacement"] = {move.x(), move.y()};
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 6; ++column) {
        about[row ? "b" : "a"].push_back(table.maps[region - 1].coefficients(row, column));
        if (table.deviations) about[row ? "b_sd" : "a_sd"].push_back(table.deviations->at(region - 1)(row, column));
      }
    list.push_back(about);
  }
  return list;
}

DeformationFigureOptions drawingOf(const FdtShowCommandOptions& options) {
  DeformationFigureOptions drawing;
  drawing.magnification = parseNumber("--arrows", options.magnification);
  if (!(drawing.magnification > 0.0 && drawing.magnification <= 100.0))
    throw ValueFailure(
        "--arrows " + options.magnification +
        " is not allowed; give a factor above 0 and at most 100: 1 draws displacements in the face's own "
        "scale");
  drawing.coefficients = !options.noCoefficients;
  drawing.hard = options.deformation.hard;
  return drawing;
}

Plate plateOf(const FdtShowCommandOptions& options, const DeformationTable& table, const FacialRegions& regions,
              double width) {
  DeformationFigureOptions drawing = drawingOf(options);
  const FaceArrows face = genericFaceArrows(table, options.deformation, arrowSpacing(width));
  const FaceLines lines = genericFaceLines(regions);
  drawing.faceLines = lines.curves;
  drawing.featureLines = lines.features;
  drawing.arrows = face.arrows;
  drawing.pupilUnit = face.pupilUnit;
  Plate plate = deformationPlate(table, regions, drawing, width);
  plate.title = "Deformation table " + shortTableName(options.table);
  plate.note = options.table + "; on the generic face; Mien " MIEN_VERSION;
  return plate;
}

void run(const FdtShowCommandOptions& options) {
  options.report.check();
  drawingOf(options);
  const MarkerFileOptions& reading = options.deformation.reading;
  const FacialRegions regions = reading.regions();
  const TableInput input = readTableOrRecording(options.table, reading, regions);
  reading.refuseForTables(input.markers.has_value(), options.table);
  const DeformationTable& table = input.table;
  Report report;
  report.rows = coefficientRows(table);
  report.readable = readableRows(table, regions);
  const double largest = fittedDisplacement(table, regions);
  report.json = {{"table", options.table},
                 {"deviations", table.deviations.has_value()},
                 {"largest_displacement", largest},
                 {"regions", regionList(table, regions)}};
  report.remarks = {"largest displacement " + readableNumber(largest) + " pupil units" +
                    (table.deviations ? "; +- is one standard deviation" : "")};
  const std::string unknown = describeUnknown(table);
  if (!unknown.empty()) report.remarks.push_back(unknown);
  report.plate = [&](double width) { return plateOf(options, table, regions, width); };
  options.report.deliver(report);
}

}  // namespace

void addFdtShowCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtShowCommandOptions>();
  CLI::App* command = parent.add_subcommand("show", "Print a table, and draw its regions and displacements on a face");
  command->add_option("table", options->table, "Table, or a recording that is fitted")->required();
  options->report.addTo(*command);
  command->add_option("--arrows", options->magnification, "Magnification of the displacements")
      ->capture_default_str()
      ->group("Chart");
  command->add_flag("--no-coefficients", options->noCoefficients, "Only the drawings")->group("Chart");
  command
      ->add_flag("--hard", options->deformation.hard,
                 "Arrows of hard regions, as mien fdt apply --hard moves points; else of smooth ones")
      ->group("Chart");
  options->deformation.reading.addTo(*command, true);
  command->footer(
      "Example: mien fdt show joy -o joy.pdf -o joy.svg --width 170\n"
      "         mien fdt show anna_joy.csv --json\n"
      "The .csv file has a row for each coefficient: value, standard deviation, low and high end of its range.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
