#include <CLI/CLI.hpp>
#include <memory>

#include "Command.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "OutputFile.h"
#include "Remarks.h"
#include "SurfaceFile.h"
#include "SurfaceTable.h"
#include "vtkPDEFaceFilter.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

struct SurfaceCommandOptions {
  FaceOptions face;
  std::string output;
};

void run(const SurfaceCommandOptions& options) {
  requireSurfaceOrTable(options.output);
  FacePipeline pipeline;
  options.face.apply(pipeline);
  FaceState state = pipeline.state();
  state.doublePrecision = state.doublePrecision || isTable(options.output);  // a table has all digits
  pipeline.setState(state);
  updateOrThrow(pipeline);
  printRemarks(pipeline);
  vtkStructuredGrid* grid = pipeline.grid();
  if (isTable(options.output))
    OutputFile::write(options.output, faceTable(RowLayout(state.rows, state.uniformRows), grid));
  else
    writeSurface(grid, options.output);
}

}  // namespace

void addSurfaceCommand(CLI::App& program) {
  const auto options = std::make_shared<SurfaceCommandOptions>();
  CLI::App* command = program.add_subcommand("surface", "Write the PDE surface of a face");
  command->add_option("-o,--output", options->output, "File to write: .vts .vtp .ply .obj .stl .off .csv")->required();
  options->face.addAll(*command);
  command->footer(
      "Example: mien surface -a 2 -N 7 --resolution 110x80 --expression joy -o joy.vtp\n"
      "A .vts file keeps the grid with the mouth slit hidden; .csv has the columns patch,u,v,x,y,z in double "
      "precision.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
