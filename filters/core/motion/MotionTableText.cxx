#include "MotionTableText.h"

#include "NumberText.h"

namespace mien {

std::string motionTableText(const MotionField& field, const std::vector<int>& chosen) {
  std::string text = "u,v,x,y,z,dx,dy,dz,magnitude_mm\n";
  for (const int row : chosen) {
    if (!field.u.empty()) appendNumber(text, field.u[row]);
    text += ',';
    if (!field.v.empty()) appendNumber(text, field.v[row]);
    for (const ClosedCurves::Points* points : {&field.origins, &field.vectors})
      for (int axis = 0; axis < 3; ++axis) appendNumber(text += ',', (*points)(row, axis));
    appendNumber(text += ',', field.vectors.row(row).norm());
    text += '\n';
  }
  return text;
}

}  // namespace mien
