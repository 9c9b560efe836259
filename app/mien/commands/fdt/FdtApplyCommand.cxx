#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "Arguments.h"
#include "DeformedFace.h"
#include "FDTData.h"
#include "Failure.h"
#include "FdtCommands.h"
#include "OutputFile.h"
#include "ReportOptions.h"
#include "SurfaceFile.h"
#include "TableInput.h"
#include "TableOutput.h"
#include "TableRows.h"
#include "WholeMesh.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace mien {

namespace {

struct FdtApplyCommandOptions {
  std::vector<std::string> inputs;
  std::string outputFile, strength = "1";
  bool json = false;
  DeformationOptions deformation;
};

struct Movement {
  long points = 0, moved = 0;
  double largest = 0.0;

  void add(const Eigen::Vector3d& move) {
    ++points;
    moved += move.norm() > 0.0;
    largest = std::max(largest, move.norm());
  }
};

Movement moveMarkers(const FdtApplyCommandOptions& options, const std::string& file, const DeformationTable& table) {
  PointTable points = readPoints(file, options.deformation.reading);
  const PointTable before = points;
  deformMarkers(points, table, options.deformation, file);
  Movement movement;
  for (std::size_t i = 0; i < points.points.size(); ++i)
    if (points.points[i].seen) movement.add(points.points[i].position - before.points[i].position);
  OutputFile::write(options.outputFile, points.write(options.deformation.reading.markers()));
  return movement;
}

Movement moveSurface(const FdtApplyCommandOptions& options, const std::string& file, const DeformationTable& table) {
  const auto surface = readWholeMesh(file);
  const auto moved = deformSurface(vtkPointSet::SafeDownCast(surface), table, options.deformation, file);
  vtkDataArray* moves = moved->GetPointData()->GetArray("Displacement");
  Movement movement;
  Eigen::Vector3d move;
  for (vtkIdType i = 0; moves && i < moves->GetNumberOfTuples(); ++i) {
    moves->GetTuple(i, move.data());
    movement.add(move);
  }
  writeMovedMesh(moved, file, options.outputFile);
  return movement;
}

/// The face is the last of the inputs; the tables stand before it.
void check(const FdtApplyCommandOptions& options, bool markers) {
  if (options.inputs.size() < 2)
    throw ValueFailure("give a table and a face: mien fdt apply joy head.ply -o smiling.ply");
  requireEnding(options.outputFile, markers ? std::vector<std::string>{"csv"} : surfaceEndings());
  const OutputFile writable(options.outputFile);
  if (!markers && options.deformation.reading.turnsAxes())
    throw ValueFailure("--y-down and --mirrored are for marker files; surfaces have y up and x to the subject's left");
  if (markers && !options.deformation.landmarks.empty())
    throw ValueFailure("--landmarks is for surfaces; markers are told by their names");
}

void print(const FdtApplyCommandOptions& options, const Movement& movement) {
  if (options.json) {
    const nlohmann::ordered_json about = {{"file", options.inputs.back()},
                                          {"output", options.outputFile},
                                          {"points", movement.points},
                                          {"moved", movement.moved},
                                          {"largest_displacement", movement.largest}};
    std::cout << about.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
    return;
  }
  std::cout << movement.moved << " of " << movement.points << " points moved, by up to "
            << readableNumber(movement.largest) << " in the file's unit\n";
}

void run(const FdtApplyCommandOptions& given) {
  FdtApplyCommandOptions options = given;
  const std::string face = options.inputs.back();
  const bool markers = fileEnding(face) == "csv";
  check(options, markers);
  options.deformation.strength = parseNumber("--strength", options.strength);
  if (std::abs(options.deformation.strength) > 2.0)
    throw ValueFailure("--strength is outside -2 .. 2; 1 is the table as it is");
  options.inputs.pop_back();
  const DeformationTable table = readWeightedTables(options.inputs);
  const std::string unknown = describeUnknown(table);
  if (!unknown.empty()) std::cerr << "mien: " << unknown << "\n";
  options.inputs.push_back(face);
  print(options, markers ? moveMarkers(options, face, table) : moveSurface(options, face, table));
}

}  // namespace

void addFdtApplyCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtApplyCommandOptions>();
  CLI::App* command = parent.add_subcommand("apply", "Move markers or any head by a table, or several");
  command
      ->add_option("inputs", options->inputs,
                   "TABLE[:WEIGHT] .., weights -2 .. 2, then the face: markers FILE.csv (marker, x, y, optionally z, "
                   "region), or a surface "
                   ".ply .obj .stl .off .vtp .vts")
      ->required();
  command
      ->add_option("-o,--output", options->outputFile,
                   "Face to write: .csv of markers; .ply .obj .stl .off .vtp .vts of surfaces")
      ->required();
  command->add_flag("--json", options->json, "Machine-readable results on stdout");
  command->add_option("--strength", options->strength, "Factor on all displacements, -2 .. 2")->capture_default_str();
  command->add_flag(
      "--hard", options->deformation.hard,
      "Every point follows the nearest region alone, as in the paper; else neighbours blend. The movement "
      "fades out at the face's outline in both");
  options->deformation.reading.addTo(*command, false);
  command
      ->add_option(
          "--landmarks", options->deformation.landmarks,
          "68 landmarks of a head, FILE.csv by vertex or place: for its pupils and to tell lips and lids apart")
      ->group("Reading faces");
  command->footer(
      "Example: mien fdt apply joy head.ply --landmarks head68.csv -o smiling.ply\n"
      "         mien fdt apply joy:0.5 surprise:0.5 head.obj --pupils 31,37,83,-31,37,83 -o surprised.obj\n"
      "         mien fdt apply smile points.csv --hard -o smiling.csv\n"
      "Displacements of several tables add up, each times its weight. Pupils among markers stay; z is carried along.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
