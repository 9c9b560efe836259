#include <CLI/CLI.hpp>
#include <memory>

#include "Command.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceScene.h"
#include "FaceStateText.h"
#include "OutputFile.h"
#include "Picture.h"
#include "Remarks.h"
#include "RenderOptions.h"
#include "VirtualDisplay.h"
#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

struct Options {
  FaceOptions face;
  RenderOptions picture{"1000x1000"};
  std::string output;
};

void run(const Options& options) {
  requireEnding(options.output, {"png"});
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
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("render", "Draw a face");
  command->add_option("-o,--output", options->output, "File to write: .png")->required();
  options->picture.addTo(*command);
  options->face.addAll(*command);
  options->face.addTextureOptions(*command);
  command->footer(
      "Example: mien render --expression surprise --view 45 --size 1200x1200 -o surprise.png\n"
      "         mien render --texture painted --expression joy -o joy.png\n"
      "The picture carries the face's state as text. Without a display a private Xvfb is started.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
