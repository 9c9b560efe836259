#pragma once

#include <sys/types.h>

namespace mien {

/// A display to render on: the user's own, or else a private virtual one for as long as the object lives.
///
/// VTK aborts the process when it finds no display, so this comes before every render window and outlives it.
class VirtualDisplay {
 public:
  /// Starts Xvfb when there is no display that answers. Throws a FileFailure when that is not possible.
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  void start();

  pid_t server_ = -1;
};

}  // namespace mien
