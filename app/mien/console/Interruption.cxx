#include "Interruption.h"

#include <csignal>

namespace mien {

namespace {

volatile std::sig_atomic_t interrupted = 0;  // how often

void note(int signal) {
  interrupted = interrupted + 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void noteInterruptions() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

bool wasInterrupted() {
  return interrupted > 0;
}

void noteSecondInterruption() {
  noteInterruptions();
}

bool wasInterruptedTwice() {
  return interrupted > 1;
}

}  // namespace mien
