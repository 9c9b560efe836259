#include <cstdio>
#include <filesystem>

#include "AnimationFrames.h"
#include "Failure.h"
#include "FrameSink.h"
#include "Picture.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

class PictureFolderSink : public FrameSink {
 public:
  explicit PictureFolderSink(const std::string& folder) : folder_(folder) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (!fs::is_directory(folder_, error)) throw FileFailure(folder + ": cannot be made a folder for the frames");
  }

  bool needsPictures() const override { return true; }

  void add(const AnimationFrame& frame, vtkStructuredGrid*, vtkImageData* picture) override {
    writePNG(picture, fileOf(count_).string(), {{"Software", "Mien " MIEN_VERSION}, {"Comment", frame.caption}});
    ++count_;
  }

  std::string finish(bool complete) override {
    std::error_code error;
    for (int i = count_; complete && fs::remove(fileOf(i), error); ++i) {
    }
    return std::to_string(count_) + " frames in " + folder_.string();
  }

 private:
  fs::path fileOf(int index) const {
    char name[32];
    std::snprintf(name, sizeof name, "frame_%04d.png", index);
    return folder_ / name;
  }

  fs::path folder_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> makePictureFolderSink(const std::string& folder) {
  return std::make_unique<PictureFolderSink>(folder);
}

}  // namespace mien
