#include "MotionTableText.h"

#include <cmath>

#include "NumberText.h"

namespace mien {

namespace {

const char* const columns = "u,v,x,y,z,dx,dy,dz,magnitude_mm\n";
constexpr double leastComponent = 1e-9;  // mm

double withoutRounding(double component) {
  return std::abs(component) < leastComponent ? 0.0 : component;
}

void appendRow(const MotionField& field, int row, std::string& text) {
  if (!field.u.empty()) appendNumber(text, field.u[row]);
  text += ',';
  if (!field.v.empty()) appendNumber(text, field.v[row]);
  for (int axis = 0; axis < 3; ++axis) appendNumber(text += ',', withoutRounding(field.origins(row, axis)));
  for (int axis = 0; axis < 3; ++axis) appendNumber(text += ',', withoutRounding(field.vectors(row, axis)));
  appendNumber(text += ',', withoutRounding(field.vectors.row(row).norm()));
  text += '\n';
}

}  // namespace

std::string motionTableText(const MotionField& field, const std::vector<int>& chosen) {
  std::string text = columns;
  for (const int row : chosen) appendRow(field, row, text);
  return text;
}

std::string motionTableText(const std::vector<MotionTablePart>& parts) {
  std::string text = std::string("frame,") + columns;
  for (const MotionTablePart& part : parts)
    for (const int row : *part.chosen) appendRow(*part.field, row, text += part.frame + ',');
  return text;
}

}  // namespace mien
