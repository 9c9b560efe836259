#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "vtkAOSDataArrayTemplate.h"
#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

namespace mien {

/// Output arrays of a filter that runs again and again: one that nobody else holds any more is written anew, since
/// asking the system for memory takes longer than filling it (1000 x 1000 points with normals: 12 of 18 ms).
template <class Scalar>
class ReusedArrays {
 public:
  using Array = vtkSmartPointer<vtkAOSDataArrayTemplate<Scalar>>;

  /// An array of that name and size; its numbers are anything.
  Array take(const char* name, int components, vtkIdType size) {
    for (const Array& array : kept_)
      if (array->GetReferenceCount() == 1 && fits(array, name, components, size)) {
        array->Modified();
        return array;
      }
    Array array = make(name, components, size);
    keep(array);
    return array;
  }

 private:
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
    const auto isNamesake = [&](const Array& other) { return other->GetName() == std::string(array->GetName()); };
    if (std::count_if(kept_.begin(), kept_.end(), isNamesake) >= mostOfOneName)
      kept_.erase(std::find_if(kept_.begin(), kept_.end(), isNamesake));
    kept_.push_back(array);
  }

  std::vector<Array> kept_;
};

}  // namespace mien
