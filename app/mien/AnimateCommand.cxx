#include "AnimationFrames.h"
#include "Arguments.h"
#include "Command.h"
#include "ContactSheet.h"
#include "DataFile.h"
#include "FAPSequence.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceScene.h"
#include "Failure.h"
#include "FrameSink.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "ProgressLine.h"
#include "Remarks.h"
#include "RenderOptions.h"
#include "VirtualDisplay.h"

#include "vtkFAPReader.h"
#include "vtkImageData.h"
#include "vtkPDEFaceFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>

namespace mien {

namespace {

constexpr int samplesOfFrames = 2;  // along each side of a pixel; a film has many pixels and moves

struct Options {
  FaceOptions face;
  RenderOptions picture{"640x800"};
  std::string file, output, sheet, fps, range;
};

/// A name without an ending is a folder.
bool isFolder(const std::string& name) { return fileEnding(name).empty() || name.back() == '/'; }

void checkOutputs(const Options& options) {
  if (options.output.empty() && options.sheet.empty())
    throw ValueFailure("there is nothing to write; give -o, --contact-sheet or both");
  if (!options.output.empty() && !isFolder(options.output)) requireEnding(options.output, {"pvd", "ogv", "mp4"});
  if (!options.sheet.empty()) requireEnding(options.sheet, {"png"});
}

std::string animationFile(const Options& options) {
  const std::string file = options.file.empty() ? findDataFile("animation/demo.fap") : options.file;
  if (file.empty()) throw FileFailure("animation/demo.fap: the bundled animation is not installed; give a FILE.fap");
  return file;
}

double parseRate(const std::string& text) {
  const double rate = text.empty() ? 0.0 : parseNumber("--fps", text);
  if (!text.empty() && !(rate > 0.0 && rate <= 1000.0)) throw ValueFailure("--fps " + text + " is outside 0 < fps <= 1000");
  return rate;
}

std::unique_ptr<FrameSink> makeSink(const std::string& output, double framesPerSecond) {
  if (output.empty()) return nullptr;
  if (isFolder(output)) return makePictureFolderSink(output);
  return fileEnding(output) == "pvd" ? makeSurfaceSeriesSink(output) : makeMovieSink(output, framesPerSecond);
}

/// One animation on its way to its sink and its contact sheet.
class Animation {
 public:
  explicit Animation(const Options& options) : options_(options), style_(options.picture.style()) {
    FaceOptions face = options.face;
    if (fileEnding(options.output) != "pvd") options.picture.chooseResolution(face);
    face.setAnimation(animationFile(options));
    style_.samples = samplesOfFrames;
    face.apply(pipeline_);
    const double rate = parseRate(options.fps);
    const FAPSequence& sequence = pipeline_.frames()->GetSequence();
    frames_ = chooseFrames(sequence, options.range, rate);
    sink_ = makeSink(options.output, rate > 0.0 ? rate : sequence.framesPerSecond);
    if (!options.sheet.empty()) prepareSheet();
    if (sheet_ || (sink_ && sink_->needsPictures())) prepareScene();
  }

  /// Throws Stopped when the user interrupts it; what is finished then stays.
  void run() {
    noteInterruptions();
    int done = 0;
    {
      ProgressLine progress(static_cast<int>(frames_.size()));
      for (; done < static_cast<int>(frames_.size()) && !wasInterrupted(); ++done) {
        progress.show(done);
        addFrame(done);
      }
    }
    finish(done == static_cast<int>(frames_.size()), done);
  }

 private:
  void show(const AnimationFrame& frame) {
    FaceState state = pipeline_.state();
    state.frameChoice = frame.choice;
    state.frame = frame.value;
    state.interpolateFrames = frame.choice == FaceState::FrameChoice::Time;
    pipeline_.setState(state);
  }

  void prepareSheet() {
    const OutputFile writable(options_.sheet);  // better known now than after the last frame
    sheet_.emplace(static_cast<int>(frames_.size()));
  }

  /// The camera stands still and has all in view that the animation will show.
  void prepareScene() {
    vtkNew<vtkPoints> visited;
    for (const AnimationFrame& frame : frames_) {
      show(frame);
      const std::string fault = pipeline_.updateCurves();
      if (!fault.empty()) throw FileFailure(fault);
      auto* curves = vtkPolyData::SafeDownCast(pipeline_.curves()->GetOutputDataObject(0));
      visited->InsertPoints(visited->GetNumberOfPoints(), curves->GetNumberOfPoints(), 0, curves->GetPoints());
    }
    vtkNew<vtkPolyData> all;
    all->SetPoints(visited);
    updateOrThrow(pipeline_);
    display_.emplace();
    scene_.emplace(pipeline_, style_);
    scene_->placeCamera(all);
  }

  void addFrame(int index) {
    show(frames_[index]);
    updateOrThrow(pipeline_);
    const bool onSheet = sheet_ && sheet_->wants(index);
    const bool picture = onSheet || (sink_ && sink_->needsPictures());
    const vtkSmartPointer<vtkImageData> image = picture ? scene_->render() : nullptr;
    if (sink_) sink_->add(frames_[index], pipeline_.grid(), image);
    if (onSheet) sheet_->add(image, frames_[index].caption);
  }

  void finish(bool complete, int done) {
    const std::string result = sink_ ? sink_->finish(complete) : "";
    if (sheet_ && complete) sheet_->write(options_.sheet);
    printRemarks(pipeline_);
    if (!complete)
      throw Stopped("stopped after " + std::to_string(done) + " of " + std::to_string(frames_.size()) + " frames" +
                    (result.empty() ? "" : "; there are " + result));
    if (sink_) std::cout << result << "\n";
    if (sheet_) std::cout << "contact sheet in " << options_.sheet << "\n";
  }

  const Options& options_;
  SceneStyle style_;
  FacePipeline pipeline_;
  std::vector<AnimationFrame> frames_;
  std::unique_ptr<FrameSink> sink_;
  std::optional<ContactSheet> sheet_;
  std::optional<VirtualDisplay> display_;
  std::optional<FaceScene> scene_;
};

void run(const Options& options) {
  checkOutputs(options);
  Animation animation(options);
  animation.run();
}

}  // namespace

void addAnimateCommand(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("animate", "Play an animation into pictures, surfaces or a film");
  command->add_option("file", options->file, "Facial animation parameters, FILE.fap [the bundled animation]");
  command->add_option("-o,--output", options->output, "Folder of .png frames, or a file: .pvd .ogv .mp4");
  command->add_option("--contact-sheet", options->sheet, "Evenly chosen frames side by side, FILE.png");
  command->add_option("--range", options->range, "FIRST:LAST, frame numbers as written in the file [all]");
  command->add_option("--fps", options->fps, "Moments per second, mixed from the frames around them [the frames]");
  options->picture.addTo(*command);
  options->face.addSurfaceOptions(*command);
  command->footer(
      "Example: mien animate speech.fap -o frames/ --contact-sheet sheet.png\n"
      "         mien animate speech.fap --scheme tangent --view 45 -o speech.ogv\n"
      "Ctrl-C stops between two frames and leaves finished files only.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
