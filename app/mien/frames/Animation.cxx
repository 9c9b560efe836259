#include "Animation.h"

#include <iostream>
#include <set>
#include <utility>

#include "Counted.h"
#include "CsvText.h"
#include "DataFile.h"
#include "FAPSequence.h"
#include "Failure.h"
#include "FrameName.h"
#include "Interruption.h"
#include "OutputFile.h"
#include "ProgressLine.h"
#include "vtkFAPReader.h"
#include "vtkImageData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr int pollInterval = 100;   // ms between looks at Ctrl-C
constexpr int mostReads = 10000;    // of what has come, when a stream is stopped: a pipe that is always full has an end
constexpr int samplesOfFrames = 2;  // along each side of a pixel; a film has many pixels and moves

/// A name without an ending is a folder.
bool isFolder(const std::string& name) {
  return fileEnding(name).empty() || name.back() == '/';
}

std::string animationFile(const AnimationOptions& options) {
  const std::string file = options.file.empty() ? findDataFile("animation/demo.fap") : options.file;
  if (file.empty()) throw FileFailure("animation/demo.fap: the bundled animation is not installed; give a FILE.fap");
  return file;
}

std::unique_ptr<FrameSink> makeSink(const AnimationOptions& options, double framesPerSecond) {
  const std::string& output = options.output;
  if (output.empty()) return nullptr;
  if (isFolder(output)) return makePictureFolderSink(output);
  if (isNumberedByFrame(output)) return makeNumberedFilesSink(output);
  return fileEnding(output) == "pvd" ? makeSurfaceSeriesSink(output, options.series)
                                     : makeMovieSink(output, framesPerSecond);
}

}  // namespace

void AnimationOptions::check() const {
  if (output.empty() && sheet.empty())
    throw ValueFailure("there is nothing to write; give -o, --contact-sheet or both");
  if (!sheet.empty()) requireEnding(sheet, {"png"});
  if (series != "vts" && series != "vtp")
    throw ValueFailure("--series '" + series + "' is no kind of surface; there are vts and vtp");
  if (isLive() && (frames.areChosen() || !sheet.empty()))
    throw ValueFailure(
        "standard input is played as it comes; --range, --frames, --start, --end, --loop, --fps and --contact-sheet "
        "need a file");
  if (isNumberedByFrame(output) && !(frames.fps + frames.loop).empty())
    throw ValueFailure("output '" + output +
                       "' is named by numbers of frames; --fps and --loop make moments without one");
}

Animation::Animation(const AnimationOptions& options)
    : options_(options), style_(options.picture.style()), visited_(style_.view) {
  FaceOptions face = options.face;
  const bool grids = fileEnding(options.output) == "pvd";
  if (!grids) options.picture.chooseResolution(face);
  style_.samples = samplesOfFrames;
  if (!options.isLive()) face.setAnimation(animationFile(options));
  face.apply(pipeline_);
  noteInterruptions();
  options.isLive() ? waitForStream() : prepareFile();
}

void Animation::prepareFile() {
  const FAPSequence& sequence = pipeline_.frames()->GetSequence();
  frames_ = chooseFrames(sequence, options_.frames);
  if (isNumberedByFrame(options_.output)) checkFrames();
  sink_ = makeSink(options_, rateOf(sequence, options_.frames));
  if (!options_.sheet.empty()) prepareSheet();
  if (!drawsPictures()) return;
  visitFrames();
  placeScene();
}

void Animation::checkFrames() const {
  std::set<std::string> numbers;
  for (const AnimationFrame& frame : frames_)
    if (!numbers.insert(frame.number).second)
      throw ValueFailure("frame number " + frame.number + " occurs twice; leave {frame} out of the output's name");
}

void Animation::prepareSheet() {
  const OutputFile writable(options_.sheet);  // better known now than after the last frame
  sheet_.emplace(static_cast<int>(frames_.size()));
}

void Animation::show(const AnimationFrame& frame) {
  FaceState state = pipeline_.state();
  state.frameChoice = frame.choice;
  state.frame = frame.value;
  state.interpolateFrames = frame.choice == FaceState::FrameChoice::Time;
  pipeline_.setState(state);
}

/// The curves bound the surface, but for a table that bends it.
vtkPoints* Animation::visiblePoints() {
  const bool bent = !pipeline_.state().deformation.table.empty();
  const std::string fault = bent ? pipeline_.updateGrid() : pipeline_.updateCurves();
  if (!fault.empty()) throw FileFailure(fault);
  if (bent) return pipeline_.grid()->GetPoints();
  return vtkPolyData::SafeDownCast(pipeline_.curves()->GetOutputDataObject(0))->GetPoints();
}

/// The camera stands still and has all in view that the animation will show; repetitions show nothing new.
void Animation::visitFrames() {
  const int once = static_cast<int>(frames_.size()) / options_.frames.repetitions();
  ProgressLine progress(once, "looking for the extent, frame");
  for (int index = 0; index < once; ++index) {
    if (wasInterrupted()) throw Stopped("stopped before the first frame; nothing was written");
    progress.show(index);
    show(frames_[index]);
    visited_.add(visiblePoints());
  }
}

void Animation::placeScene() {
  const auto neutral = style_.neutralFrame ? neutralSurface(pipeline_) : nullptr;
  updateOrThrow(pipeline_);
  display_.emplace();
  scene_.emplace(pipeline_, style_);
  neutral ? scene_->placeCamera(neutral, visited_.points()) : scene_->placeCamera(visited_.points());
}

void Animation::update(bool picture) {
  if (picture) return updateOrThrow(pipeline_);
  const std::string fault = pipeline_.updateGrid();
  if (!fault.empty()) throw FileFailure(fault);
}

void Animation::runFile() {
  const int count = static_cast<int>(frames_.size());
  int done = 0;
  {
    ProgressLine progress(count);
    for (; done < count && !wasInterrupted(); ++done) {
      progress.show(done);
      addFrame(done);
    }
  }
  finish(done == count, done);
}

void Animation::addFrame(int index) {
  const bool onSheet = sheet_ && sheet_->wants(index);
  const bool picture = onSheet || (sink_ && sink_->needsPictures());
  show(frames_[index]);
  update(picture);
  contact_.add(pipeline_);
  const vtkSmartPointer<vtkImageData> image = picture ? scene_->render() : nullptr;
  if (sink_) sink_->add(frames_[index], pipeline_.grid(), image);
  if (onSheet) sheet_->add(image, frames_[index].caption);
}

void Animation::finish(bool complete, int done) {
  const std::string result = sink_ ? sink_->finish(complete) : "";
  if (sheet_ && complete) sheet_->write(options_.sheet);
  printRemarks(pipeline_, contact_);
  if (!complete)
    throw Stopped("stopped after " + std::to_string(done) + " of " + counted(frames_.size(), "frame") +
                  (result.empty() ? "" : "; what is left: " + result));
  if (sink_) std::cout << result << "\n";
  if (sheet_) std::cout << "contact sheet in " << options_.sheet << "\n";
}

/// Until the first frame of standard input is there, or its end.
void Animation::waitForStream() {
  while (arrived_.empty() && input_.wait(pollInterval, arrived_) == FAPLiveInput::State::Open)
    if (wasInterrupted()) throw Stopped("stopped before the first frame; nothing was written");
  if (arrived_.empty()) throw FileFailure(input_.fault());
  sink_ = makeSink(options_, input_.sequence().framesPerSecond);
  pipeline_.frames()->StartStream(input_.sequence().framesPerSecond, input_.sequence().name);
  if (!drawsPictures()) return;
  visited_.add(visiblePoints());
  placeScene();
}

/// Each frame as soon as it has come. @return whether the stream was good to its end or the interruption
bool Animation::playStream(int& done) {
  FAPLiveInput::State state = FAPLiveInput::State::Open;
  ProgressLine progress(0);
  while (!wasInterrupted() && (state == FAPLiveInput::State::Open || !arrived_.empty())) {
    size_t shown = 0;
    for (; shown < arrived_.size() && !wasInterrupted(); ++shown) {
      progress.show(done);
      addStreamFrame(arrived_[shown], done++);
    }
    arrived_.erase(arrived_.begin(), arrived_.begin() + static_cast<std::ptrdiff_t>(shown));
    if (state == FAPLiveInput::State::Open && !wasInterrupted()) state = input_.wait(pollInterval, arrived_);
  }
  if (wasInterrupted() && state == FAPLiveInput::State::Open) drainStream();
  return state != FAPLiveInput::State::Failed;
}

/// What the stream has given up to now; that its last line may be cut off is the stop's doing.
void Animation::drainStream() {
  FAPLiveInput::State state = FAPLiveInput::State::Open;
  size_t known = 0;
  for (int reads = 0; reads < mostReads && state == FAPLiveInput::State::Open; ++reads) {
    known = arrived_.size();
    state = input_.wait(0, arrived_);
    if (arrived_.size() == known) break;
  }
}

/// Nobody can play a stream again: what came before the stop is drawn, unless a second one ends that too.
void Animation::drawWaiting(int& done) {
  if (!wasInterrupted() || arrived_.empty()) return;
  noteSecondInterruption();
  std::cerr << "mien: stopped; drawing the last " << counted(arrived_.size(), "frame")
            << " that came before; Ctrl-C again leaves them out\n";
  ProgressLine progress(done + static_cast<int>(arrived_.size()));
  size_t shown = 0;
  for (; shown < arrived_.size() && !wasInterruptedTwice(); ++shown) {
    progress.show(done);
    addStreamFrame(arrived_[shown], done++);
  }
  left_ = static_cast<int>(arrived_.size() - shown);
}

/// What was finished stays when the stream turns out to be wrong or is stopped: nobody can play it again.
void Animation::runStream() {
  int done = 0;
  const bool good = playStream(done);
  drawWaiting(done);
  for (const FAPWarning& warning : input_.sequence().warnings)
    std::cerr << "mien: standard input:" << warning.line << ": " << warning.message << "\n";
  const std::string result = sink_->finish(done > 0);
  printRemarks(pipeline_, contact_);
  if (!good) throw FileFailure(input_.fault() + "; what is left: " + result);
  if (wasInterrupted())
    throw Stopped("stopped after " +
                  (left_ > 0 ? std::to_string(done) + " of " + counted(done + left_, "frame") + " that came"
                             : counted(done, "frame")) +
                  "; what is left: " + result);
  std::cout << result << "\n";
}

void Animation::addStreamFrame(const FAPFrame& frame, int index) {
  pipeline_.frames()->ClearFrames();
  pipeline_.frames()->AppendFrame(frame);
  FaceState state = pipeline_.state();
  state.fapFile = "-";
  pipeline_.setState(state);
  update(sink_->needsPictures());
  contact_.add(pipeline_);
  const vtkSmartPointer<vtkImageData> image = sink_->needsPictures() ? scene_->render() : nullptr;
  const double time = index / input_.sequence().framesPerSecond;
  const std::string number = shortestText(frame.number);
  sink_->add({FaceState::FrameChoice::Index, 0.0, time, "frame " + number, number}, pipeline_.grid(), image);
}

}  // namespace mien
