#pragma once

#include <string>
#include <vector>

#include "MienSurfaceModule.h"

class vtkAlgorithm;
class vtkCommand;

namespace mien {

/// What the filters of a pipeline report, kept instead of printed to the console.
///
/// An observed filter is silent; its own message comes without the class and line of source that VTK puts before it.
/// May be destroyed before the filters.
class MIENSURFACE_EXPORT PipelineErrors {
 public:
  PipelineErrors();
  ~PipelineErrors();
  PipelineErrors(const PipelineErrors&) = delete;
  PipelineErrors& operator=(const PipelineErrors&) = delete;

  void observe(vtkAlgorithm* algorithm);  ///< from now on, beside those observed before

  /// What hears the events, for objects within a filter that take an observer of their own.
  vtkCommand* observer() const;

  /// The first error since the last clear(), which those after it follow from; nothing when there was none.
  std::string first() const;

  /// All warnings since the last clear().
  std::vector<std::string> warnings() const;

  void clear();  ///< forgets errors and warnings

 private:
  class Keeper;
  Keeper* Kept;
};

}  // namespace mien
