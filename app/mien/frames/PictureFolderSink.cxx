#include "AnimationFrames.h"
#include "Counted.h"
#include "FrameFiles.h"
#include "FrameSink.h"
#include "Picture.h"

namespace mien {

namespace {

class PictureFolderSink : public FrameSink {
 public:
  explicit PictureFolderSink(const std::string& folder) : files_(folder, "frame", "png") {}

  bool needsPictures() const override { return true; }

  void add(const AnimationFrame& frame, vtkStructuredGrid*, vtkImageData* picture) override {
    writePNG(picture, files_.path(count_), {{"Software", "Mien " MIEN_VERSION}, {"Comment", frame.caption}});
    ++count_;
  }

  std::string finish(bool) override {
    files_.removeOthers(count_);
    return counted(count_, "frame") + " in " + files_.folder();
  }

 private:
  FrameFiles files_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> makePictureFolderSink(const std::string& folder) {
  return std::make_unique<PictureFolderSink>(folder);
}

}  // namespace mien
