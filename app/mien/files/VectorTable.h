#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "MotionField.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace mien {

/// How many vectors, how many of them move, largest and mean (mm), and where the largest starts.
nlohmann::ordered_json vectorSummary(const MotionField& field, const std::vector<int>& chosen);

/// The chosen vectors with all point arrays of `vectors`, and u and v where there are any.
vtkSmartPointer<vtkPolyData> chosenVectors(vtkPolyData* vectors, const MotionField& field,
                                           const std::vector<int>& chosen);

}  // namespace mien
