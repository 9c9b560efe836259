#pragma once

#include <memory>
#include <string>
#include <vector>

class vtkImageData;
class vtkStructuredGrid;

namespace mien {

struct AnimationFrame;

/// What becomes of the frames of an animation.
class FrameSink {
 public:
  virtual ~FrameSink() = default;

  /// Whether add() wants pictures; else it wants surfaces.
  virtual bool needsPictures() const = 0;

  /// @param picture  3 or 4 components; nullptr when none are needed
  virtual void add(const AnimationFrame& frame, vtkStructuredGrid* surface, vtkImageData* picture) = 0;

  /// All frames were added, or those before an interruption: of what is one file nothing stays then. Without this call
  /// nothing unfinished stays.
  /// @return what there is now, for people
  virtual std::string finish(bool complete) = 0;
};

/// A folder of frame_0000.png, frame_0001.png, ..; frames of an earlier, longer run are removed.
std::unique_ptr<FrameSink> makePictureFolderSink(const std::string& folder);

/// A file for each frame, named by the number of the frame in the animation's file in place of {frame}.
std::unique_ptr<FrameSink> makeNumberedFilesSink(const std::string& pattern);

/// A ParaView time series: NAME.pvd and a folder NAME of surfaces, without those of an earlier, longer run.
/// @param ending  "vts", the grid with its blanked mouth, or "vtp", polygons without it
std::unique_ptr<FrameSink> makeSurfaceSeriesSink(const std::string& name, const std::string& ending);

/// A film: .ogv by VTK, all others by ffmpeg, when that is installed. Throws a FileFailure when it is not, a
/// ValueFailure for an ending that it does not know.
std::unique_ptr<FrameSink> makeMovieSink(const std::string& name, double framesPerSecond);

/// The usual endings of a file that an animation can be written to; an installed ffmpeg knows more.
std::vector<std::string> animationEndings();

}  // namespace mien
