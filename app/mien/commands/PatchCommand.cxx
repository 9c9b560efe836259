#include <CLI/CLI.hpp>
#include <memory>

#include "Arguments.h"
#include "BoundaryCurveData.h"
#include "Command.h"
#include "CompactFaceFile.h"
#include "Failure.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "SurfaceFile.h"
#include "SurfaceTable.h"
#include "XMLDataFile.h"
#include "vtkNew.h"
#include "vtkPDEPatchFilter.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"

namespace mien {

namespace {

struct PatchCommandOptions {
  std::string curves, output, resolution = "40x40", smoothing = "1", harmonics = "5", precision = "single";
  std::vector<std::string> conditions;
  bool noRemainder = false;
};

vtkSmartPointer<vtkPolyData> readCurves(const std::string& name) {
  if (isCompactFaceFile(name))
    throw FileFailure(name + ": a face has 29 curves, and a patch takes 2 to 16; give its curves alone, in a .vtp");
  vtkNew<vtkXMLPolyDataReader> reader;
  const std::string unreadable = readXMLDataFile(name, reader);
  if (!unreadable.empty()) throw FileFailure(unreadable);
  ClosedCurves curves;
  const std::string fault = readClosedCurves(reader->GetOutput(), curves);
  if (!fault.empty()) throw FileFailure(name + ": " + fault);
  return reader->GetOutput();
}

void addConditions(const std::vector<std::string>& conditions, vtkPDEPatchFilter* patch) {
  for (const std::string& text : conditions) {
    const std::vector<std::string> parts = splitText(text, ':');
    if (parts.size() > 2) throw ValueFailure("--condition '" + text + "' is none; write U:DERIVATIVE as 0.5:1");
    const int derivative = parts.size() == 2 ? parseWholeNumber("--condition", parts[1]) : 0;
    patch->AddCondition(parseNumber("--condition", parts[0]), derivative);
  }
}

void setOptions(const PatchCommandOptions& options, vtkPDEPatchFilter* patch) {
  addConditions(options.conditions, patch);
  patch->SetSmoothing(parseNumber("-a", options.smoothing));
  patch->SetNumberOfModes(parseWholeNumber("--harmonics", options.harmonics));
  patch->SetRemainder(!options.noRemainder);
  const auto [rows, columns] = parseSize("--resolution", options.resolution);
  patch->SetResolution(rows, columns);
  const bool doublePrecision = options.precision == "double" || isTable(options.output);
  patch->SetOutputPointsPrecision(doublePrecision ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::SINGLE_PRECISION);
}

/// What is wrong with the curves, their arrays and the conditions, whatever a, N and resolution.
void requirePatch(const PatchCommandOptions& options, vtkPolyData* curves) {
  vtkNew<vtkPDEPatchFilter> patch;
  PipelineErrors errors;
  errors.observe(patch);
  addConditions(options.conditions, patch);
  patch->SetNumberOfModes(0);
  patch->SetResolution(2, 3);
  patch->SetInputData(curves);
  patch->Update();
  if (errors.first().empty()) return;
  const std::string fault = options.curves + ": " + errors.first();
  if (options.conditions.empty()) throw FileFailure(fault);
  throw ValueFailure(fault);
}

void run(const PatchCommandOptions& options) {
  requireSurfaceOrTable(options.output);
  const auto curves = readCurves(options.curves);
  requirePatch(options, curves);
  vtkNew<vtkPDEPatchFilter> patch;
  setOptions(options, patch);
  PipelineErrors errors;
  errors.observe(patch);
  patch->SetInputData(curves);
  patch->Update();
  if (!errors.first().empty()) throw ValueFailure(options.curves + ": " + errors.first());
  if (isTable(options.output))
    OutputFile::write(options.output, patchTable(patch->GetOutput()));
  else
    writeSurface(patch->GetOutput(), options.output);
}

}  // namespace

void addPatchCommand(CLI::App& program) {
  const auto options = std::make_shared<PatchCommandOptions>();
  CLI::App* command = program.add_subcommand("patch", "Write one PDE patch between any closed curves");
  command->add_option("curves", options->curves, "Closed polylines of equal length, FILE.vtp")->required();
  command->add_option("-o,--output", options->output, "File to write: .vts .vtp .ply .obj .stl .off .csv")->required();
  command->add_option("--condition", options->conditions,
                      "U[:DERIVATIVE] of the next curve, once for each [arrays U and Derivative of the file, "
                      "else equal steps of u]");
  command->add_option("-a,--smoothing", options->smoothing, "Smoothing parameter a, 0 < a <= 1000")
      ->capture_default_str();
  command->add_option("-N,--harmonics", options->harmonics, "Fourier modes solved exactly, 0 .. K/2")
      ->capture_default_str();
  command->add_flag("--no-remainder", options->noRemainder, "Leave out the harmonics above N");
  command->add_option("--resolution", options->resolution, "Rows x columns of the uv mesh")->capture_default_str();
  command->add_option("--precision", options->precision, "Of points and arrays")
      ->capture_default_str()
      ->check(CLI::IsMember({"single", "double"}));
  command->footer(
      "Example: mien patch vase.vtp --condition 0 --condition 0:1 --condition 1 --condition 1:1 -o vase.vts\n"
      "As many conditions as curves, an even number: their count is the order of the equation.\n"
      "Normals and polygons face outwards when the curves run anticlockwise, seen from the first towards the last.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
