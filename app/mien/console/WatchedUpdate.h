#pragma once

class vtkAlgorithm;

namespace mien {

/// Updates a filter that takes long: its progress is shown, and Ctrl-C ends it with a Stopped that says so.
///
/// @param what  is computed, for the message: "sweep"
void updateWatched(vtkAlgorithm* filter, const char* what);

}  // namespace mien
