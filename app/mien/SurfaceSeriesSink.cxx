#include <cstdio>
#include <filesystem>

#include "AnimationFrames.h"
#include "CsvText.h"
#include "Failure.h"
#include "FrameSink.h"
#include "OutputFile.h"
#include "SurfaceFile.h"

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
      : name_(name), ending_(ending), folder_(fs::path(name).replace_extension()) {
    const OutputFile writable(name);
    std::error_code error;
    fs::create_directories(folder_, error);
    if (!fs::is_directory(folder_, error))
      throw FileFailure(folder_.string() + ": cannot be made a folder for the surfaces");
  }

  bool needsPictures() const override { return false; }

  void add(const AnimationFrame& frame, vtkStructuredGrid* surface, vtkImageData*) override {
    char number[16];
    std::snprintf(number, sizeof number, "_%04d.", count_++);
    const std::string file = folder_.filename().string() + number + ending_;
    writeSurface(surface, (folder_ / file).string());
    entries_ += "    <DataSet timestep=\"" + shortestText(frame.time) + "\" part=\"0\" file=\"" +
                escaped(folder_.filename().string() + "/" + file) + "\"/>\n";
  }

  std::string finish(bool) override {
    OutputFile::write(
        name_, "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n" + entries_ +
                   "  </Collection>\n</VTKFile>\n");
    return std::to_string(count_) + " surfaces in " + name_;
  }

 private:
  std::string name_, ending_;
  fs::path folder_;
  std::string entries_;
  int count_ = 0;
};

}  // namespace

std::unique_ptr<FrameSink> makeSurfaceSeriesSink(const std::string& name, const std::string& ending) {
  return std::make_unique<SurfaceSeriesSink>(name, ending);
}

}  // namespace mien
