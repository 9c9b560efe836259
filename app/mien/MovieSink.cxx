#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "AnimationFrames.h"
#include "CsvText.h"
#include "Failure.h"
#include "FrameSink.h"
#include "OutputFile.h"
#include "Picture.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkNew.h"
#include "vtkOggTheoraWriter.h"

namespace mien {

namespace {

constexpr int notInstalled = 127;
const char* const evenSides = "pad=ceil(iw/2)*2:ceil(ih/2)*2";                   // the usual colour format halves them
const char* const ownPalette = "split[a][b];[a]palettegen[p];[b][p]paletteuse";  // a .gif has 256 colours
const char* const ffmpegEndings[] = {"mp4", "m4v", "mov", "webm", "mkv", "avi", "mpg", "gif", "apng", "webp"};

bool isOneOf(const std::string& ending, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return ending == one; });
}

/// How ffmpeg writes a kind of file: what is played widely.
std::vector<std::string> ffmpegFormat(const std::string& ending) {
  if (ending == "gif") return {"-vf", ownPalette, "-loop", "0"};
  if (ending == "apng") return {"-plays", "0"};
  if (ending == "webp") return {"-loop", "0"};
  std::vector<std::string> format = {"-vf", evenSides, "-pix_fmt", "yuv420p"};
  if (isOneOf(ending, {"mp4", "m4v", "mov"})) format.insert(format.end(), {"-movflags", "+faststart"});
  return format;
}

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
    if (!installed())
      throw FileFailure(name + ": ." + fileEnding(name) +
                        " needs ffmpeg, which is not installed; install it (apt-get install ffmpeg) or write .ogv");
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
  static bool installed() {
    const pid_t child = fork();
    if (child == 0) become({"ffmpeg", "-version"}, -1, -1);
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

  [[noreturn]] static void become(std::vector<std::string> command, int input, int messages) {
    setpgid(0, 0);  // Ctrl-C in the terminal is for us
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(input >= 0 ? input : nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(messages >= 0 ? messages : nowhere, STDERR_FILENO);
    std::vector<char*> arguments;
    for (std::string& argument : command) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(notInstalled);
  }

  void start(const int size[3]) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw FileFailure(file_.name() + ": there is no pipe to ffmpeg");
    const std::string shape = std::to_string(size[0]) + "x" + std::to_string(size[1]);
    child_ = fork();
    std::vector<std::string> command = {"ffmpeg",   "-y",    "-loglevel", "error", "-f", "rawvideo",
                                        "-pix_fmt", "rgb24", "-s",        shape,   "-r", shortestText(rate_),
                                        "-i",       "-"};
    for (const std::string& word : ffmpegFormat(fileEnding(file_.name()))) command.push_back(word);
    command.push_back(file_.temporaryName());
    if (child_ == 0) become(command, ends[0], messages_ ? fileno(messages_) : -1);
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
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
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
