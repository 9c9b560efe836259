#include "WatchedUpdate.h"

#include <string>

#include "Failure.h"
#include "FilterProgress.h"
#include "Interruption.h"
#include "ProgressLine.h"

namespace mien {

void updateWatched(vtkAlgorithm* filter, const char* what) {
  noteInterruptions();
  ProgressLine line;
  updateWith(
      [&](double done) {
        line.showShare(done);
        return !wasInterrupted();
      },
      filter);
  if (wasInterrupted()) throw Stopped("stopped before the " + std::string(what) + " was complete; nothing was written");
}

}  // namespace mien
