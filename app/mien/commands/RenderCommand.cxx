#include <CLI/CLI.hpp>
#include <memory>

#include "Command.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceScene.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "OutputFile.h"
#include "OutwardMesh.h"
#include "Picture.h"
#include "Remarks.h"
#include "RenderOptions.h"
#include "VirtualDisplay.h"
#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

struct RenderCommandOptions {
  FaceOptions face;
  RenderOptions picture{"1000x1000"};
  std::string mesh, output;
};

/// A mesh from a file, which nothing of the face's options moves or paints.
void drawMesh(const RenderCommandOptions& options) {
  const SceneStyle style = options.picture.style();
  if (options.face.state() != FaceOptions().state() || style.curves)
    throw ValueFailure(options.mesh +
                       " is drawn as it is: leave out the options of the face, or make it a face with `mien acquire " +
                       options.mesh + " -o FACE.vtp` and draw that with --face FACE.vtp");
  const auto mesh = outwardMesh(options.mesh);
  const VirtualDisplay display;
  SurfaceScene scene(mesh, style);
  writePNG(scene.render(), options.output, {{"Software", "Mien " MIEN_VERSION}});
}

void run(const RenderCommandOptions& options) {
  requireEnding(options.output, {"png"});
  if (!options.mesh.empty()) return drawMesh(options);
  const SceneStyle style = options.picture.style();
  FacePipeline pipeline;
  FaceOptions face = options.face;
  options.picture.chooseResolution(face);
  face.apply(pipeline);
  const auto neutral = style.neutralFrame ? neutralSurface(pipeline) : nullptr;
  updateOrThrow(pipeline);
  printRemarks(pipeline);
  const VirtualDisplay display;
  FaceScene scene(pipeline, style);
  if (neutral) scene.placeCamera(neutral, vtkPolyData::SafeDownCast(pipeline.surface()->GetOutputDataObject(0)));
  writePNG(scene.render(), options.output,
           {{"Software", "Mien " MIEN_VERSION}, {"MienFaceState", writeFaceState(pipeline.state())}});
}

}  // namespace

void addRenderCommand(CLI::App& program) {
  const auto options = std::make_shared<RenderCommandOptions>();
  CLI::App* command = program.add_subcommand("render", "Draw a face, or a mesh as it is");
  command->add_option("mesh", options->mesh, "Mesh to draw in place of the face: .ply .obj .stl .off .vtp .vts");
  command->add_option("-o,--output", options->output, "File to write: .png")->required();
  options->picture.addTo(*command);
  options->face.addAll(*command);
  options->face.addTextureOptions(*command);
  command->footer(
      "Example: mien render --expression surprise --view 45 --size 1200x1200 -o surprise.png\n"
      "         mien render --texture painted --expression joy -o joy.png\n"
      "         mien render a_joy.ply --view 45 -o a_joy.png\n"
      "The picture carries the face's state as text. Without a display a private Xvfb is started.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
