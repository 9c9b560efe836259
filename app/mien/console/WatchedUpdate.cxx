#include "WatchedUpdate.h"

#include <string>

#include "Failure.h"
#include "FilterProgress.h"
#include "Interruption.h"
#include "ProgressLine.h"

namespace mien {

namespace {

constexpr int progressSteps = 1000;

}  // namespace

void updateWatched(vtkAlgorithm* filter, const char* what) {
  noteInterruptions();
  ProgressLine line(progressSteps, "part");
  updateWith(
      [&](double done) {
        line.show(static_cast<int>(progressSteps * done));
        return !wasInterrupted();
      },
      filter);
  if (wasInterrupted()) throw Stopped("stopped before the " + std::string(what) + " was complete; nothing was written");
}

}  // namespace mien
