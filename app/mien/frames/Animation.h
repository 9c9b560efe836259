#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "AnimationFrames.h"
#include "ContactSheet.h"
#include "FAPLiveInput.h"
#include "FaceOptions.h"
#include "FacePipeline.h"
#include "FaceScene.h"
#include "FrameOptions.h"
#include "FrameSink.h"
#include "OutermostPoints.h"
#include "Remarks.h"
#include "RenderOptions.h"
#include "VirtualDisplay.h"

class vtkPoints;

namespace mien {

/// What to play, and into what.
struct AnimationOptions {
  FaceOptions face;
  RenderOptions picture{"640x800"};
  std::string file, output, sheet, series = "vts";
  FrameOptions frames;

  bool isLive() const { return file == "-"; }

  /// Throws a ValueFailure for options that do not fit each other.
  void check() const;
};

/// One animation on its way to its sink and its contact sheet. All but the destructor may throw a Failure.
class Animation {
 public:
  explicit Animation(const AnimationOptions& options);

  /// Throws Stopped when the user interrupts it; what is finished then stays.
  void run() { options_.isLive() ? runStream() : runFile(); }

 private:
  bool drawsPictures() const { return sheet_ || (sink_ && sink_->needsPictures()); }

  void prepareFile();
  void checkFrames() const;
  void prepareSheet();
  void visitFrames();
  void placeScene();
  void show(const AnimationFrame& frame);
  vtkPoints* visiblePoints();
  void update(bool picture);
  void runFile();
  void addFrame(int index);
  void finish(bool complete, int done);

  void waitForStream();
  bool playStream(int& done);
  void drainStream();
  void drawWaiting(int& done);
  void runStream();
  void addStreamFrame(const FAPFrame& frame, int index);

  const AnimationOptions& options_;
  SceneStyle style_;
  FacePipeline pipeline_;
  FAPLiveInput input_;
  std::vector<FAPFrame> arrived_;  ///< of the stream, not shown yet
  int left_ = 0;                   ///< how many of them were never shown
  std::vector<AnimationFrame> frames_;
  ContactCount contact_;
  std::unique_ptr<FrameSink> sink_;
  std::optional<ContactSheet> sheet_;
  OutermostPoints visited_;
  std::optional<VirtualDisplay> display_;
  std::optional<FaceScene> scene_;
};

}  // namespace mien
