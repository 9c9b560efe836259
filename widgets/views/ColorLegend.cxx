#include "ColorLegend.h"

#include <vtkLookupTable.h>
#include <vtkPolyDataMapper.h>
#include <vtkVariant.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "ColorTable.h"
#include "PatchColors.h"

namespace mien {

namespace {

constexpr int blueToOrange[] = {0x16467f, 0x3b7bb8, 0x8fb8dc, 0xf2f2ef, 0xf0b27f, 0xd4772f, 0x8a4206};
constexpr int steps = 256;
constexpr double unknownGrey = 0.66;  // as light as the middle of the scales, so that it is lit alike

/// Between neighbours linear.
QColor divergingAt(double share) {
  const double place = share * (std::size(blueToOrange) - 1);
  const size_t i = std::min(static_cast<size_t>(place), std::size(blueToOrange) - 2);
  const QColor a(static_cast<QRgb>(blueToOrange[i])), b(static_cast<QRgb>(blueToOrange[i + 1]));
  const double t = place - i, s = 1.0 - t;
  return QColor::fromRgbF(s * a.redF() + t * b.redF(), s * a.greenF() + t * b.greenF(), s * a.blueF() + t * b.blueF());
}

}  // namespace

void ColorLegend::Scale::mark(const double range[2]) {
  const double rounding = 1e-9 * (end - begin);
  undercut = undercut || range[0] < begin - rounding;
  exceeded = exceeded || range[1] > end + rounding;
}

ColorLegend::ColorLegend() {
  colors_->SetNanColor(unknownGrey, unknownGrey, unknownGrey, 1.0);
}

ColorLegend::~ColorLegend() = default;

QColor ColorLegend::unknownColor() {
  return QColor::fromRgbF(unknownGrey, unknownGrey, unknownGrey);
}

QColor ColorLegend::colorAt(Colors colors, double share) {
  if (colors == Colors::Diverging) return divergingAt(share);
  const ColorTable::Rgb color = ColorTable::find("viridis")->at(share);
  return QColor::fromRgbF(color[0], color[1], color[2]);
}

void ColorLegend::setScale(const Scale& scale) {
  colors_->ResetAnnotations();
  colors_->IndexedLookupOff();
  colors_->SetNumberOfTableValues(steps);
  for (int i = 0; i < steps; ++i) {
    const QColor color = colorAt(scale.colors, i / (steps - 1.0));
    colors_->SetTableValue(i, color.redF(), color.greenF(), color.blueF());
  }
  colors_->SetTableRange(scale.begin, scale.end);
  colors_->Modified();
}

void ColorLegend::setPatches() {
  const int count = static_cast<int>(patchColors.size());
  colors_->ResetAnnotations();
  colors_->SetNumberOfTableValues(count);
  colors_->IndexedLookupOn();
  for (int i = 0; i < count; ++i) {
    const QColor color(static_cast<QRgb>(patchColors[i]));
    colors_->SetTableValue(i, color.redF(), color.greenF(), color.blueF());
    colors_->SetAnnotation(vtkVariant(i), std::to_string(i));
  }
  colors_->Modified();
}

void ColorLegend::color(vtkPolyDataMapper* mapper, int component) const {
  if (component < 0) {
    colors_->SetVectorModeToMagnitude();
  } else {
    colors_->SetVectorModeToComponent();
    colors_->SetVectorComponent(component);
  }
  mapper->ScalarVisibilityOn();
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(colors_);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetInterpolateScalarsBeforeMapping(!colors_->GetIndexedLookup());
}

}  // namespace mien
