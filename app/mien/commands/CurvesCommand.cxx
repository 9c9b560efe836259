#include <CLI/CLI.hpp>
#include <memory>

#include "BoundaryCurveData.h"
#include "Command.h"
#include "CompactFaceOutput.h"
#include "CsvText.h"
#include "FaceLayout.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "Failure.h"
#include "OutputFile.h"
#include "PolyDataFile.h"
#include "Remarks.h"
#include "vtkAlgorithm.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

struct CurvesCommandOptions {
  FaceOptions face;
  CompactFaceOutput compact;
  std::string output;
};

std::string curveTable(const ClosedCurves& curves) {
  std::string text = "curve,point,x,y,z\n";
  for (int index = 0; index < curves.count; ++index)
    for (int j = 0; j < curves.pointsPerCurve; ++j)
      text += FaceLayout::curveName(index) + "," + std::to_string(j) +
              coordinatesEndingLine(curves.points.row(index * curves.pointsPerCurve + j).data());
  return text;
}

void writeTable(vtkPolyData* data, const std::string& name) {
  FaceCurves face;
  const std::string fault = readFaceCurves(data, face);
  if (!fault.empty()) throw FileFailure(name + ": " + fault);
  OutputFile::write(name, curveTable(face.curves));
}

void write(const CurvesCommandOptions& options, vtkPolyData* curves) {
  const std::string ending = fileEnding(options.output);
  if (ending == "csv") return writeTable(curves, options.output);
  ending == "mienz" ? options.compact.write(curves, options.output) : writePolyData(curves, options.output);
}

void run(const CurvesCommandOptions& options) {
  requireEnding(options.output, {"vtp", "csv", "mienz"});
  options.compact.check(options.output);
  FacePipeline pipeline;
  options.face.apply(pipeline);
  const std::string fault = pipeline.updateCurves();
  if (!fault.empty()) throw FileFailure(fault);
  printRemarks(pipeline);
  write(options, vtkPolyData::SafeDownCast(pipeline.shownCurves()->GetOutputDataObject(0)));
}

}  // namespace

void addCurvesCommand(CLI::App& program) {
  const auto options = std::make_shared<CurvesCommandOptions>();
  CLI::App* command = program.add_subcommand("curves", "Write the boundary curves of a face, animated or not");
  command->add_option("-o,--output", options->output, "File to write: .vtp .csv .mienz")->required();
  options->face.addAll(*command);
  options->compact.addTo(*command);
  command->footer(
      "Example: mien curves --fap speech.fap --time 1.5 -o curves.csv\n"
      "         mien curves --face anna.vtp --tolerance 0.1mm --name Anna -o anna.mienz\n"
      "A .vtp file or a compact face file (.mienz, about 1 kB) can be given to --face; .csv has the columns "
      "curve,point,x,y,z (mm).");
  command->callback([options] { run(*options); });
}

}  // namespace mien
