#include "Ffmpeg.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <initializer_list>

#include "Arguments.h"
#include "OutputFile.h"

namespace mien {

namespace {

constexpr int notInstalled = 127;
const char* const evenSides = "pad=ceil(iw/2)*2:ceil(ih/2)*2";                   // the usual colour format halves them
const char* const ownPalette = "split[a][b];[a]palettegen[p];[b][p]paletteuse";  // a .gif has 256 colours

bool isOneOf(const std::string& ending, std::initializer_list<const char*> list) {
  return std::any_of(list.begin(), list.end(), [&](const char* one) { return ending == one; });
}

[[noreturn]] void become(std::vector<std::string> command, int input, int output, int messages) {
  setpgid(0, 0);  // Ctrl-C in the terminal is for us
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(input >= 0 ? input : nowhere, STDIN_FILENO);
  dup2(output >= 0 ? output : nowhere, STDOUT_FILENO);
  dup2(messages >= 0 ? messages : nowhere, STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(notInstalled);
}

/// What ffmpeg prints.
std::string outputOf(const std::vector<std::string>& arguments) {
  std::FILE* file = std::tmpfile();
  if (!file) return {};
  Ffmpeg::wait(Ffmpeg::start(arguments, -1, fileno(file), -1));
  std::rewind(file);
  std::string text;
  char part[4096];
  for (size_t count = 0; (count = std::fread(part, 1, sizeof part, file)) > 0;) text.append(part, count);
  std::fclose(file);
  return text;
}

/// Whether an ending is that of single pictures.
bool isPicture(const std::string& ending) {
  const std::string text = outputOf({"-hide_banner", "-h", "muxer=image2"}), label = "Common extensions: ";
  const size_t begin = text.find(label);
  if (begin == std::string::npos) return false;
  const size_t first = begin + label.size();
  const std::vector<std::string> pictures =
      splitText(text.substr(first, text.find_first_of(".\n", first) - first), ',');
  return std::find(pictures.begin(), pictures.end(), ending) != pictures.end();
}

}  // namespace

pid_t Ffmpeg::start(const std::vector<std::string>& arguments, int input, int output, int messages) {
  std::vector<std::string> command = {"ffmpeg"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const pid_t child = fork();
  if (child == 0) become(command, input, output, messages);
  return child;
}

bool Ffmpeg::wait(pid_t child) {
  int status = 0;
  if (child <= 0) return false;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool Ffmpeg::isInstalled() {
  return wait(start({"-version"}, -1, -1, -1));
}

bool Ffmpeg::canWrite(const std::string& name) {
  const OutputFile trial(name);
  const std::string ending = fileEnding(name);
  if (isPicture(ending)) return false;
  std::vector<std::string> arguments = {"-y",    "-loglevel", "quiet", "-f", "rawvideo",  "-pix_fmt",  "rgb24", "-s",
                                        "64x64", "-r",        "25",    "-i", "/dev/zero", "-frames:v", "2"};
  for (const std::string& word : format(ending)) arguments.push_back(word);
  arguments.push_back(fileArgument(trial.temporaryName()));
  return wait(start(arguments, -1, -1, -1));
}

std::vector<std::string> Ffmpeg::format(const std::string& ending) {
  if (ending == "gif") return {"-vf", ownPalette, "-loop", "0"};
  if (ending == "apng") return {"-plays", "0"};
  if (ending == "webp") return {"-loop", "0"};
  std::vector<std::string> format = {"-vf", evenSides, "-pix_fmt", "yuv420p"};
  if (isOneOf(ending, {"mp4", "m4v", "mov"})) format.insert(format.end(), {"-movflags", "+faststart"});
  return format;
}

}  // namespace mien
