#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "AnimationFrames.h"
#include "Command.h"
#include "ContactSheet.h"
#include "CsvText.h"
#include "DataFile.h"
#include "FAPLiveInput.h"
#include "FAPSequence.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceScene.h"
#include "Failure.h"
#include "FrameOptions.h"
#include "FrameSink.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "ProgressLine.h"
#include "Remarks.h"
#include "RenderOptions.h"
#include "VirtualDisplay.h"
#include "vtkFAPReader.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr int pollInterval = 100;   // ms between looks at Ctrl-C
constexpr int samplesOfFrames = 2;  // along each side of a pixel; a film has many pixels and moves

struct Options {
  FaceOptions face;
  RenderOptions picture{"640x800"};
  std::string file, output, sheet, series = "vts";
  FrameOptions frames;

  bool isLive() const { return file == "-"; }
};

/// A name without an ending is a folder.
bool isFolder(const std::string& name) {
  return fileEnding(name).empty() || name.back() == '/';
}

void checkOutputs(const Options& options) {
  if (options.output.empty() && options.sheet.empty())
    throw ValueFailure("there is nothing to write; give -o, --contact-sheet or both");
  if (!options.output.empty() && !isFolder(options.output)) requireEnding(options.output, animationEndings());
  if (!options.sheet.empty()) requireEnding(options.sheet, {"png"});
  if (options.series != "vts" && options.series != "vtp")
    throw ValueFailure("--series '" + options.series + "' is no kind of surface; there are vts and vtp");
  if (options.isLive() && (options.frames.areChosen() || !options.sheet.empty()))
    throw ValueFailure(
        "standard input is played as it comes; --range, --start, --end, --loop, --fps and --contact-sheet need a file");
}

std::string animationFile(const Options& options) {
  const std::string file = options.file.empty() ? findDataFile("animation/demo.fap") : options.file;
  if (file.empty()) throw FileFailure("animation/demo.fap: the bundled animation is not installed; give a FILE.fap");
  return file;
}

std::unique_ptr<FrameSink> makeSink(const Options& options, double framesPerSecond) {
  const std::string& output = options.output;
  if (output.empty()) return nullptr;
  if (isFolder(output)) return makePictureFolderSink(output);
  return fileEnding(output) == "pvd" ? makeSurfaceSeriesSink(output, options.series)
                                     : makeMovieSink(output, framesPerSecond);
}

/// One animation on its way to its sink and its contact sheet.
class Animation {
 public:
  explicit Animation(const Options& options) : options_(options), style_(options.picture.style()) {
    FaceOptions face = options.face;
    if (fileEnding(options.output) != "pvd") options.picture.chooseResolution(face);
    style_.samples = samplesOfFrames;
    if (!options.isLive()) face.setAnimation(animationFile(options));
    face.apply(pipeline_);
    options.isLive() ? waitForStream() : prepareFile();
  }

  /// Throws Stopped when the user interrupts it; what is finished then stays.
  void run() { options_.isLive() ? runStream() : runFile(); }

 private:
  void prepareFile() {
    const FAPSequence& sequence = pipeline_.frames()->GetSequence();
    frames_ = chooseFrames(sequence, options_.frames);
    sink_ = makeSink(options_, rateOf(sequence, options_.frames));
    if (!options_.sheet.empty()) prepareSheet();
    if (sheet_ || (sink_ && sink_->needsPictures())) prepareScene();
  }

  void runFile() {
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

  /// Until the first frame of standard input is there, or its end.
  void waitForStream() {
    noteInterruptions();
    while (arrived_.empty() && input_.wait(pollInterval, arrived_) == FAPLiveInput::State::Open)
      if (wasInterrupted()) throw Stopped("stopped before the first frame");
    if (arrived_.empty()) throw FileFailure(input_.fault());
    sink_ = makeSink(options_, input_.sequence().framesPerSecond);
    if (sink_->needsPictures()) showCurves(animatedPoints(pipeline_));
  }

  /// Each frame as soon as it has come. What is finished stays when the stream turns out to be wrong.
  void runStream() {
    int done = 0;
    FAPLiveInput::State state = FAPLiveInput::State::Open;
    ProgressLine progress(0);
    while (!wasInterrupted() && (state == FAPLiveInput::State::Open || !arrived_.empty())) {
      for (const FAPFrame& frame : std::exchange(arrived_, {})) {
        if (wasInterrupted()) break;
        progress.show(done);
        addStreamFrame(frame, done++);
      }
      if (state == FAPLiveInput::State::Open) state = input_.wait(pollInterval, arrived_);
    }
    for (const FAPWarning& warning : input_.sequence().warnings)
      std::cerr << "mien: standard input:" << warning.line << ": " << warning.message << "\n";
    if (state == FAPLiveInput::State::Failed) {
      const std::string result = sink_->finish(false);
      throw FileFailure(input_.fault() + "; there are " + result);
    }
    finish(!wasInterrupted(), done);
  }

  void addStreamFrame(const FAPFrame& frame, int index) {
    const double rate = input_.sequence().framesPerSecond, time = index / rate;
    pipeline_.frames()->StartStream(rate, input_.sequence().name);
    pipeline_.frames()->AppendFrame(frame);
    FaceState state = pipeline_.state();
    state.fapFile = "-";
    pipeline_.setState(state);
    updateOrThrow(pipeline_);
    const vtkSmartPointer<vtkImageData> image = sink_->needsPictures() ? scene_->render() : nullptr;
    sink_->add({FaceState::FrameChoice::Index, 0.0, time, "frame " + shortestText(frame.number)},
               pipeline_.face()->GetOutput(), image);
  }

  static vtkSmartPointer<vtkPoints> animatedPoints(FacePipeline& pipeline) {
    const std::string fault = pipeline.updateCurves();
    if (!fault.empty()) throw FileFailure(fault);
    return vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0))->GetPoints();
  }

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
      const vtkSmartPointer<vtkPoints> points = animatedPoints(pipeline_);
      visited->InsertPoints(visited->GetNumberOfPoints(), points->GetNumberOfPoints(), 0, points);
    }
    showCurves(visited);
  }

  void showCurves(vtkPoints* visited) {
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
      throw Stopped("stopped after " + std::to_string(done) +
                    (options_.isLive() ? "" : " of " + std::to_string(frames_.size())) + " frames" +
                    (result.empty() ? "" : "; there are " + result));
    if (sink_) std::cout << result << "\n";
    if (sheet_) std::cout << "contact sheet in " << options_.sheet << "\n";
  }

  const Options& options_;
  SceneStyle style_;
  FacePipeline pipeline_;
  FAPLiveInput input_;
  std::vector<FAPFrame> arrived_;  ///< of the stream, not shown yet
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
  command->add_option("file", options->file,
                      "FILE.fap or .csv; - is a .fap stream on standard input [the bundled animation]");
  command->add_option("-o,--output", options->output,
                      "Folder of .png frames, or a file: .pvd .ogv, with ffmpeg .mp4 .webm .gif ..");
  command->add_option("--contact-sheet", options->sheet, "Evenly chosen frames side by side, FILE.png");
  command->add_option("--series", options->series,
                      "Surfaces of a .pvd: vts, grids, or vtp, polygons without the slit of the mouth [vts]");
  options->frames.addTo(*command);
  options->picture.addTo(*command);
  options->face.addSurfaceOptions(*command);
  options->face.addTextureOptions(*command);
  command->footer(
      "Example: mien animate speech.fap -o frames/ --contact-sheet sheet.png\n"
      "         mien animate speech.fap --scheme tangent --view 45 -o speech.ogv\n"
      "         mien animate speech.fap --start 1.5 --end 4 --fps 60 --loop 3 -o speech.mp4\n"
      "         capture | mien animate - -o frames/\n"
      "Ctrl-C stops between two frames and leaves finished files only.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
