#include "VirtualDisplay.h"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "Failure.h"

namespace mien {

namespace {

constexpr int startTimeout = 15000;  // ms; it takes about 100
constexpr int notInstalled = 127;

bool displayAnswers() {
  if (!std::getenv("DISPLAY")) return false;
  Display* display = XOpenDisplay(nullptr);
  if (display) XCloseDisplay(display);
  return display != nullptr;
}

/// In the child. The server ends with us however we end, and Ctrl-C in the terminal is for us, not for it.
[[noreturn]] void becomeServer(int numberPipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  setpgid(0, 0);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
  const std::string number = std::to_string(numberPipe);
  execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset",
         static_cast<char*>(nullptr));
  _exit(notInstalled);
}

/// The line the server writes once it is ready, or nothing when it ends or takes too long.
std::string readNumber(int pipe) {
  std::string number;
  pollfd wait{pipe, POLLIN, 0};
  char c = 0;
  while (poll(&wait, 1, startTimeout) > 0 && read(pipe, &c, 1) == 1 && c != '\n') number += c;
  return c == '\n' ? number : std::string();
}

[[noreturn]] void reportFailedStart(pid_t server) {
  kill(server, SIGTERM);
  int status = 0;
  waitpid(server, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == notInstalled)
    throw FileFailure(
        "there is no display to render on, and Xvfb is not installed; install the package xvfb or set DISPLAY");
  throw FileFailure("there is no display to render on, and Xvfb did not start; try `Xvfb -displayfd 1` to see why");
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
  if (!displayAnswers()) start();
}

void VirtualDisplay::start() {
  int ends[2];
  if (pipe(ends) != 0) throw FileFailure("there is no display to render on, and no pipe to start one with");
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const pid_t parent = getpid();
  server_ = fork();
  if (server_ == 0) becomeServer(ends[1], parent);
  close(ends[1]);
  const std::string number = server_ > 0 ? readNumber(ends[0]) : std::string();
  close(ends[0]);
  if (server_ < 0) throw FileFailure("there is no display to render on, and no process to start one with");
  if (number.empty()) reportFailedStart(server_);
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay() {
  if (server_ <= 0) return;
  unsetenv("DISPLAY");
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

}  // namespace mien
