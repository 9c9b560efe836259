#include <filesystem>
#include <future>
#include <utility>

#include "AnimationFrames.h"
#include "Counted.h"
#include "CsvText.h"
#include "FrameFiles.h"
#include "FrameSink.h"
#include "OutputFile.h"
#include "SurfaceFile.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

namespace fs = std::filesystem;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

class SurfaceSeriesSink : public FrameSink {
 public:
  SurfaceSeriesSink(const std::string& name, const std::string& ending)
      : name_(checked(name)),
        stem_(fs::path(name).stem().string()),
        isGrid_(ending == "vts"),
        files_(fs::path(name).replace_extension().string(), stem_, ending, {"vts", "vtp"}) {}

  bool needsPictures() const override { return false; }

  void add(const AnimationFrame& frame, vtkStructuredGrid* surface, vtkImageData*) override {
    vtkNew<vtkStructuredGrid> timed;  // the file's own time goes on through repetitions too
    timed->ShallowCopy(surface);
    timed->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), frame.time);
    if (isGrid_)
      writeBehind(files_.path(count_), gridBytes(timed));
    else
      writeSurface(timed, files_.path(count_));
    entries_ += "    <DataSet timestep=\"" + shortestText(frame.time) + "\" part=\"0\" file=\"" +
                escaped(stem_ + "/" + files_.name(count_)) + "\"/>\n";
    ++count_;
  }

  std::string finish(bool) override {
    waitForWriting();
    OutputFile::write(
        name_, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + entries_ +
                   "  </Collection>\n</VTKFile>\n");
    files_.removeOthers(count_);
    return counted(count_, "surface") + " in " + name_;
  }

 private:
  static const std::string& checked(const std::string& name) {
    const OutputFile writable(name);
    return name;
  }

  /// The disk works while the next frame is computed.
  void writeBehind(const std::string& file, std::string bytes) {
    waitForWriting();
    writing_ = std::async(std::launch::async, [file, bytes = std::move(bytes)] { OutputFile::write(file, bytes); });
  }

  /// Throws what went wrong.
  void waitForWriting() {
    if (writing_.valid()) writing_.get();
  }

  std::string name_, stem_;
  bool isGrid_;
  FrameFiles files_;
  std::string entries_;
  int count_ = 0;
  std::future<void> writing_;  // the last member: it ends before what it needs
};

}  // namespace

std::unique_ptr<FrameSink> makeSurfaceSeriesSink(const std::string& name, const std::string& ending) {
  return std::make_unique<SurfaceSeriesSink>(name, ending);
}

}  // namespace mien
