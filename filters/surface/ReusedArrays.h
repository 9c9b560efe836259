#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "PDESurface.h"
#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace mien {

/// Output arrays of a filter that runs again and again: one that nobody else holds any more is written anew, since
/// asking the system for memory takes longer than filling it (1000 x 1000 points with normals: 12 of 18 ms).
///
/// An array also remembers which version of the surface it holds, as long as nobody else called its Modified().
template <class Scalar>
class ReusedArrays {
 public:
  using Array = vtkSmartPointer<vtkAOSDataArrayTemplate<Scalar>>;

  /// An array to be written, and what it holds before.
  struct Taken {
    Array array;
    long version = noVersion;  ///< that its numbers are; with noVersion they are anything

    Scalar* at(vtkIdType value) const { return array->GetPointer(value); }
  };

  /// An array of that name and size, to be written.
  Taken take(const char* name, int components, vtkIdType size) {
    for (Kept& kept : kept_)
      if (kept.array->GetReferenceCount() == 1 && fits(kept.array, name, components, size)) {
        const long version = kept.array->GetMTime() == kept.time ? kept.version : noVersion;
        kept.version = noVersion;
        kept.array->Modified();
        return {kept.array, version};
      }
    const Array array = make(name, components, size);
    keep(array);
    return {array};
  }

  /// An array that was taken holds this version now.
  void setVersion(const Taken& taken, long version) {
    for (Kept& kept : kept_)
      if (kept.array == taken.array) kept = {kept.array, version, kept.array->GetMTime()};
  }

 private:
  struct Kept {
    Array array;
    long version = noVersion;
    vtkMTimeType time = 0;
  };

  static constexpr vtkIdType largestKept = 1 << 24;  ///< numbers: more would be held for nothing for too long
  static constexpr int mostOfOneName = 2;            ///< the output's, and the one before that a filter behind may hold

  static bool fits(vtkDataArray* array, const char* name, int components, vtkIdType size) {
    return array->GetName() == std::string(name) && array->GetNumberOfComponents() == components &&
           array->GetNumberOfTuples() == size;
  }

  static Array make(const char* name, int components, vtkIdType size) {
    auto array = Array::Take(vtkArrayDownCast<vtkAOSDataArrayTemplate<Scalar>>(
        vtkDataArray::CreateDataArray(vtkTypeTraits<Scalar>::VTKTypeID())));
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(size);
    return array;
  }

  void keep(const Array& array) {
    if (array->GetNumberOfValues() > largestKept) return;
    const auto isNamesake = [&](const Kept& other) { return other.array->GetName() == std::string(array->GetName()); };
    if (std::count_if(kept_.begin(), kept_.end(), isNamesake) >= mostOfOneName)
      kept_.erase(std::find_if(kept_.begin(), kept_.end(), isNamesake));
    kept_.push_back({array});
  }

  std::vector<Kept> kept_;
};

}  // namespace mien
