#include "vtkOrderedGeometryFilter.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkOrderedGeometryFilter);

namespace {

/// Puts polygons and their data in ascending order of the keys.
void sortPolygons(vtkPolyData* surface, const vtkIdType* keys) {
  vtkCellArray* const before = surface->GetPolys();
  const vtkIdType count = before->GetNumberOfCells();
  std::vector<vtkIdType> order(count);
  std::iota(order.begin(), order.end(), vtkIdType(0));
  std::stable_sort(order.begin(), order.end(), [keys](vtkIdType a, vtkIdType b) { return keys[a] < keys[b]; });
  vtkNew<vtkCellArray> polygons;
  polygons->AllocateExact(count, before->GetNumberOfConnectivityIds());
  vtkNew<vtkCellData> data;
  data->CopyAllOn();
  data->CopyAllocate(surface->GetCellData(), count);
  for (vtkIdType i = 0; i < count; ++i) {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    before->GetCellAtId(order[i], size, points);
    polygons->InsertNextCell(size, points);
    data->CopyData(surface->GetCellData(), order[i], i);
  }
  surface->SetPolys(polygons);
  surface->GetCellData()->ShallowCopy(data);
}

void reversePolygons(vtkPolyData* surface) {
  vtkNew<vtkCellArray> reversed;
  reversed->DeepCopy(surface->GetPolys());
  for (vtkIdType cell = 0; cell < reversed->GetNumberOfCells(); ++cell) reversed->ReverseCellAtId(cell);
  surface->SetPolys(reversed);
}

}  // namespace

int vtkOrderedGeometryFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                          vtkInformationVector* outputs) {
  const int result = this->Superclass::RequestData(request, inputs, outputs);
  auto* const surface = vtkPolyData::GetData(outputs);
  if (this->Reversed) reversePolygons(surface);
  const char* const name = this->GetOriginalCellIdsName();
  auto* const ids = vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetArray(name));
  if (!ids) return result;
  const vtkIdType* const keys = ids->GetPointer(0);
  const vtkIdType count = ids->GetNumberOfTuples();
  const bool polygonsOnly = surface->GetNumberOfPolys() == count && surface->GetNumberOfCells() == count;
  if (polygonsOnly && !std::is_sorted(keys, keys + count)) sortPolygons(surface, keys);
  surface->GetCellData()->RemoveArray(name);
  return result;
}

void vtkOrderedGeometryFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Reversed: " << (this->Reversed ? "on" : "off") << "\n";
}
