#include "CurveMovement.h"

#include "BoundaryCurveData.h"
#include "HeadRotation.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace mien {

vtkSmartPointer<vtkDoubleArray> curveMovement(vtkPolyData* curves, bool withoutHead) {
  vtkDataArray* displacement = curves ? curves->GetPointData()->GetArray("Displacement") : nullptr;
  if (!displacement || displacement->GetNumberOfComponents() != 3) return nullptr;
  const vtkIdType count = curves->GetNumberOfPoints();
  ClosedCurves::Points moves(count, 3), moved(count, 3);
  for (vtkIdType i = 0; i < count; ++i) {
    displacement->GetTuple(i, moves.row(i).data());
    curves->GetPoint(i, moved.row(i).data());
  }
  HeadRotation head;
  if (withoutHead && readHeadRotation(curves->GetFieldData(), head).empty() && head.turns()) {
    const ClosedCurves::Points neutral = moved - moves;
    head.undo(moved);
    moves = moved - neutral;
  }
  auto movement = vtkSmartPointer<vtkDoubleArray>::New();
  movement->SetName("Movement");
  movement->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i) movement->SetValue(i, moves.row(i).norm());
  return movement;
}

}  // namespace mien
