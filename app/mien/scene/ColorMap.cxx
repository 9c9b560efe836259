#include "ColorMap.h"

#include <string>

#include "ColorTable.h"
#include "PatchColors.h"
#include "vtkLookupTable.h"
#include "vtkVariant.h"

namespace mien {

namespace {

constexpr int steps = 256;

double part(int color, int shift) {
  return ((color >> shift) & 0xff) / 255.0;
}

}  // namespace

vtkSmartPointer<vtkLookupTable> sequentialColors(double smallest, double largest) {
  const ColorTable& viridis = *ColorTable::find("viridis");
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(steps);
  for (int i = 0; i < steps; ++i) {
    const ColorTable::Rgb color = viridis.at(i / (steps - 1.0));
    table->SetTableValue(i, color[0], color[1], color[2], 1.0);
  }
  table->SetRange(smallest, largest);
  return table;
}

vtkSmartPointer<vtkLookupTable> patchColorTable() {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  const int count = static_cast<int>(patchColors.size());
  table->SetNumberOfTableValues(count);
  table->IndexedLookupOn();
  for (int i = 0; i < count; ++i) {
    table->SetTableValue(i, part(patchColors[i], 16), part(patchColors[i], 8), part(patchColors[i], 0), 1.0);
    table->SetAnnotation(vtkVariant(i), "P" + std::to_string(i));
  }
  return table;
}

}  // namespace mien
