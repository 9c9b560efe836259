#include "AnimationFrames.h"
#include "Counted.h"
#include "FrameName.h"
#include "FrameSink.h"
#include "OutputFile.h"
#include "Picture.h"
#include "SurfaceFile.h"

namespace mien {

namespace {

class NumberedFilesSink : public FrameSink {
 public:
  explicit NumberedFilesSink(const std::string& pattern) : pattern_(pattern) {
    requireEnding(pattern, {"png", "vts", "vtp", "ply", "obj", "stl"});
    const OutputFile writable(pattern);
  }

  bool needsPictures() const override { return fileEnding(pattern_) == "png"; }

  void add(const AnimationFrame& frame, vtkStructuredGrid* surface, vtkImageData* picture) override {
    const std::string name = nameForFrame(pattern_, frame.number);
    if (needsPictures())
      writePNG(picture, name, {{"Software", "Mien " MIEN_VERSION}, {"Comment", frame.caption}});
    else
      writeSurface(surface, name);
    ++count_;
  }

  std::string finish(bool) override { return counted(count_, "file") + " named " + pattern_; }

 private:
  std::string pattern_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> makeNumberedFilesSink(const std::string& pattern) {
  return std::make_unique<NumberedFilesSink>(pattern);
}

}  // namespace mien
