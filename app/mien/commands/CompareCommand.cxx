#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "Command.h"
#include "DistanceFigure.h"
#include "Failure.h"
#include "LengthUnit.h"
#include "MeshFile.h"
#include "NumberText.h"
#include "PipelineErrors.h"
#include "PolyDataFile.h"
#include "ReportOptions.h"
#include "TableRows.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceDistanceFilter.h"
#include "vtkTable.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct CompareCommandOptions {
  std::string surface, reference, units;
  ReportOptions report{{"vtp"}};
  bool frontal = false, withSign = false, skin = false, covered = false;
};

std::string shortName(const std::string& name) {
  return std::filesystem::path(name).filename().string();
}

std::string direction(const CompareCommandOptions& options, int way) {
  const std::string a = shortName(options.surface), b = shortName(options.reference);
  return way == 0 ? a + " to " + b : b + " to " + a;
}

std::vector<double> distances(const CompareCommandOptions& options, vtkDataObject* output, double threshold) {
  auto* surface = vtkPolyData::SafeDownCast(output);
  vtkDataArray* array = surface->GetPointData()->GetArray("Distance");
  vtkDataArray* covered = surface->GetPointData()->GetArray("Covered");
  std::vector<double> values;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    if ((!options.frontal || surface->GetPoint(i)[2] > threshold) && (!covered || covered->GetTuple1(i) > 0.0))
      values.push_back(array->GetTuple1(i));
  return values;
}

Report reportOf(const CompareCommandOptions& options, vtkSurfaceDistanceFilter* filter) {
  Report report;
  report.json = {
      {"a", options.surface}, {"b", options.reference}, {"frontal", options.frontal}, {"covered", options.covered}};
  report.rows = tableRows(vtkTable::SafeDownCast(filter->GetOutputDataObject(2)));
  for (int way = 0; way < 2; ++way) {
    json& row = report.rows[way];
    row["direction"] = direction(options, way);
    json measures = row;
    measures.erase("direction");
    report.json[way == 0 ? "a_to_b" : "b_to_a"] = measures;
  }
  if (options.covered)
    report.remarks = {
        "Covered: points whose nearest point lies on the rim of the other surface, or of a hole in it, do "
        "not count; area_mm2 is what counts."};
  report.figure = [&options, filter] {
    Figure figure = distanceFigure(
        {{direction(options, 0), distances(options, filter->GetOutputDataObject(0), filter->GetFrontalThreshold())},
         {direction(options, 1), distances(options, filter->GetOutputDataObject(1), filter->GetFrontalThreshold())}});
    figure.note = std::string(options.frontal ? "Points with z > 50 mm" : "All points") +
                  (options.covered ? " that the other surface covers" : "") + "; Mien " MIEN_VERSION;
    return figure;
  };
  return report;
}

const LengthUnit* unitOf(const CompareCommandOptions& options) {
  if (options.units.empty()) return nullptr;
  const LengthUnit* unit = lengthUnit(options.units);
  if (!unit) throw ValueFailure("--units '" + options.units + "' is unknown; it is mm, cm, m or inch");
  return unit;
}

void scale(vtkDataObject* mesh, double factor) {
  auto* set = vtkPointSet::SafeDownCast(mesh);
  vtkNew<vtkPoints> scaled;
  scaled->SetDataTypeToDouble();
  scaled->SetNumberOfPoints(set->GetNumberOfPoints());
  for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i) {
    const double* p = set->GetPoint(i);
    scaled->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
  }
  set->SetPoints(scaled);
}

/// Two surfaces of heads differ by less than this unless their lengths are in different units.
void remarkOnSizes(const CompareCommandOptions& options, vtkDataObject* surface, vtkDataObject* reference) {
  constexpr double suspicious = 5.0;
  const double a = vtkPointSet::SafeDownCast(surface)->GetLength(),
               b = vtkPointSet::SafeDownCast(reference)->GetLength();
  if (!(a > 0.0 && b > 0.0) || std::max(a / b, b / a) < suspicious) return;
  std::cerr << "mien: " << shortName(options.surface) << " is " << roundedText(a) << " mm from corner to corner, "
            << shortName(options.reference) << " " << roundedText(b)
            << " mm; are both in mm? --units mm|cm|m|inch says what B is in\n";
}

void run(const CompareCommandOptions& options) {
  options.report.check();
  const auto surface = readMesh(options.surface), reference = readMesh(options.reference);
  if (const LengthUnit* unit = unitOf(options)) scale(reference, unit->millimetres);
  remarkOnSizes(options, surface, reference);
  vtkNew<vtkSurfaceDistanceFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputDataObject(0, surface);
  filter->SetInputDataObject(1, reference);
  filter->SetFrontalOnly(options.frontal);
  filter->SetSigned(options.withSign);
  filter->SetLargestComponentOnly(options.skin);
  filter->SetCoveredOnly(options.covered);
  filter->Update();
  if (!errors.first().empty()) throw FileFailure(options.surface + ", " + options.reference + ": " + errors.first());
  for (const std::string& name : options.report.outputs("vtp"))
    writePolyData(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)), name);
  options.report.deliver(reportOf(options, filter));
}

}  // namespace

void addCompareCommand(CLI::App& program) {
  const auto options = std::make_shared<CompareCommandOptions>();
  CLI::App* command = program.add_subcommand("compare", "Measure the distance between two surfaces, both ways");
  command->add_option("a", options->surface, "Surface, .vts .vtp .ply .obj .stl .off, mm")->required();
  command->add_option("b", options->reference, "The one it is compared with")->required();
  options->report.addTo(*command);
  command->add_option("--units", options->units, "What B's lengths are in: mm, cm, m or inch [mm]");
  command->add_flag("--frontal", options->frontal, "Only points with z > 50 mm count");
  command->add_flag("--signed", options->withSign, "Distances behind the other surface are negative in the .vtp file");
  command->add_flag("--largest-part", options->skin,
                    "Only the largest connected part of B counts, such as skin without eyeballs");
  command->add_flag("--covered", options->covered,
                    "Only points that the other surface covers count, both ways: not those whose nearest point lies on "
                    "its rim or that of a hole, such as a neck below a face");
  command->footer(
      "Example: mien compare face.vts scan.ply --frontal -o distance.vtp -o distance.svg\n"
      "         mien compare face.vts scan.ply --covered --largest-part\n"
      "RMS, mean, median and 95th percentile (p95) are weighted with the area around each point: 95 % of the area lie\n"
      "no further away. The .vtp file is A with the point array Distance (mm), and with --covered the array Covered (1 "
      "or 0).");
  command->callback([options] { run(*options); });
}

}  // namespace mien
