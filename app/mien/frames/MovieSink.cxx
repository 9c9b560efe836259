#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>
#include <vector>

#include "AnimationFrames.h"
#include "CsvText.h"
#include "Failure.h"
#include "Ffmpeg.h"
#include "FrameSink.h"
#include "OutputFile.h"
#include "Picture.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"

namespace mien {

namespace {

const char* const ffmpegEndings[] = {"mp4", "m4v", "mov", "webm", "mkv", "avi", "mpg", "gif", "apng", "webp"};

vtkSmartPointer<vtkImageData> colorsOf(vtkImageData* picture) {
  return picture->GetNumberOfScalarComponents() == 4 ? opaque(picture) : vtkSmartPointer<vtkImageData>(picture);
}

/// The film's format knows whole rates only: a small multiple of the rate where that is whole, else the next whole
/// number.
int wholeRate(double rate) {
  for (int multiple = 1; multiple <= 4; ++multiple) {
    const double whole = std::round(multiple * rate);
    if (whole >= 1.0 && std::abs(multiple * rate - whole) < 1e-6) return static_cast<int>(whole);
  }
  return static_cast<int>(std::ceil(rate));
}

/// Pictures are repeated where the film's rate is higher than theirs, so that it lasts as long as the animation.
class OggSink : public FrameSink {
 public:
  OggSink(const std::string& name, double rate) : file_(name), repeats_(wholeRate(rate) / rate) {
    writer_->SetFileName(file_.temporaryName().c_str());
    writer_->SetRate(wholeRate(rate));
    writer_->SetQuality(2);
  }

  ~OggSink() override {
    if (started_) writer_->End();
  }

  bool needsPictures() const override { return true; }

  void add(const AnimationFrame&, vtkStructuredGrid*, vtkImageData* picture) override {
    const auto colors = colorsOf(picture);
    writer_->SetInputData(colors);
    if (!started_) writer_->Start();
    started_ = true;
    ++pictures_;
    for (; written_ < std::lround(pictures_ * repeats_); ++written_) writer_->Write();
    if (writer_->GetError()) throw FileFailure(file_.name() + ": the film cannot be written");
  }

  std::string finish(bool complete) override {
    if (started_) writer_->End();
    started_ = false;
    if (!complete) return "no film";
    file_.commit();
    return "the film " + file_.name();
  }

 private:
  OutputFile file_;
  vtkNew<vtkOggTheoraWriter> writer_;
  double repeats_;  ///< film pictures per picture, 1 or more
  long pictures_ = 0, written_ = 0;
  bool started_ = false;
};

/// ffmpeg as a child that takes raw pictures from a pipe.
class FfmpegSink : public FrameSink {
 public:
  FfmpegSink(const std::string& name, double rate) : file_(name), rate_(rate) {
    requireFfmpeg(name);
    messages_ = std::tmpfile();
    signal(SIGPIPE, SIG_IGN);
  }

  ~FfmpegSink() override {
    close();
    if (messages_) std::fclose(messages_);
  }

  bool needsPictures() const override { return true; }

  void add(const AnimationFrame&, vtkStructuredGrid*, vtkImageData* picture) override {
    vtkNew<vtkImageFlip> topDown;
    topDown->SetInputData(colorsOf(picture));
    topDown->SetFilteredAxis(1);
    topDown->Update();
    vtkImageData* image = topDown->GetOutput();
    int size[3];
    image->GetDimensions(size);
    if (child_ <= 0) start(size);
    send(static_cast<const char*>(image->GetScalarPointer()), static_cast<size_t>(size[0]) * size[1] * 3);
  }

  std::string finish(bool complete) override {
    const bool worked = close();
    if (!complete) return "no film";
    if (!worked) throw FileFailure(file_.name() + ": ffmpeg could not write the film" + lastMessage());
    file_.commit();
    return "the film " + file_.name();
  }

 private:
  static void requireFfmpeg(const std::string& name) {
    const std::vector<std::string> usual = animationEndings();
    const std::string ending = fileEnding(name);
    const bool isUsual = std::find(usual.begin(), usual.end(), ending) != usual.end();
    const bool installed = Ffmpeg::isInstalled();
    if (isUsual && !installed)
      throw FileFailure(name + ": ." + ending +
                        " needs ffmpeg, which is not installed; install it (apt-get install ffmpeg) or write .ogv");
    if (!isUsual && !(installed && Ffmpeg::canWrite(name))) requireEnding(name, usual);
  }

  void start(const int size[3]) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw FileFailure(file_.name() + ": there is no pipe to ffmpeg");
    const std::string shape = std::to_string(size[0]) + "x" + std::to_string(size[1]);
    std::vector<std::string> arguments = {"-y",    "-loglevel", "error", "-f", "rawvideo",          "-pix_fmt",
                                          "rgb24", "-s",        shape,   "-r", shortestText(rate_), "-i",
                                          "-"};
    for (const std::string& word : Ffmpeg::format(fileEnding(file_.name()))) arguments.push_back(word);
    arguments.push_back(Ffmpeg::fileArgument(file_.temporaryName()));
    child_ = Ffmpeg::start(arguments, ends[0], -1, messages_ ? fileno(messages_) : -1);
    ::close(ends[0]);
    pipe_ = ends[1];
  }

  void send(const char* bytes, size_t count) {
    while (count > 0) {
      const ssize_t sent = write(pipe_, bytes, count);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) throw FileFailure(file_.name() + ": ffmpeg stopped before the film was complete" + lastMessage());
      bytes += sent;
      count -= static_cast<size_t>(sent);
    }
  }

  /// Ends the film; true when ffmpeg was content.
  bool close() {
    if (child_ <= 0) return false;
    ::close(pipe_);
    return Ffmpeg::wait(std::exchange(child_, -1));
  }

  /// What ffmpeg said last, for the end of a sentence.
  std::string lastMessage() {
    std::string last;
    if (!messages_) return last;
    std::rewind(messages_);
    char line[512];
    while (std::fgets(line, sizeof line, messages_))
      if (line[0] != '\n') last = line;
    while (!last.empty() && static_cast<unsigned char>(last.back()) < 0x20) last.pop_back();
    return last.empty() ? last : " (" + last + ")";
  }

  OutputFile file_;
  double rate_;
  std::FILE* messages_ = nullptr;  ///< of ffmpeg
  pid_t child_ = -1;
  int pipe_ = -1;
};

}  // namespace

std::unique_ptr<FrameSink> makeMovieSink(const std::string& name, double framesPerSecond) {
  if (fileEnding(name) == "ogv") return std::make_unique<OggSink>(name, framesPerSecond);
  return std::make_unique<FfmpegSink>(name, framesPerSecond);
}

std::vector<std::string> animationEndings() {
  std::vector<std::string> endings = {"pvd", "ogv"};
  endings.insert(endings.end(), std::begin(ffmpegEndings), std::end(ffmpegEndings));
  return endings;
}

}  // namespace mien
