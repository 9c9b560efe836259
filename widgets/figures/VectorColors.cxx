#include "VectorColors.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double mostLight = 0.72;    // luminance on light paper: viridis ends at a green, not at a yellow nobody sees
constexpr double middleShade = 0.72;  // of a diverging map on light paper: its grey at zero must be seen on white
constexpr double leastLight = 0.32;   // on dark backgrounds
constexpr int colorSteps = 255;

double luminance(const ColorTable::Rgb& color) {
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

std::string withoutTurn(const std::string& map, bool& turned) {
  turned = map.size() > 2 && map.substr(map.size() - 2) == "_r";
  return turned ? map.substr(0, map.size() - 2) : map;
}

}  // namespace

bool VectorColors::isKnown(const std::string& map) {
  bool turned = false;
  return ColorTable::find(withoutTurn(map, turned)) != nullptr;
}

VectorColors::VectorColors(const std::string& map, const FigureTheme& theme, double begin, double end)
    : begin_(begin), end_(end) {
  bool turned = false;
  table_ = ColorTable::find(withoutTurn(map, turned));
  if (!table_) table_ = &ColorTable::all().front();
  const bool dark = theme.background.lightnessF() < 0.5;
  shade_ = table_->diverging && !dark ? middleShade : 1.0;
  const auto standsOut = [&](double t) {
    const double light = luminance(table_->at(t));
    return dark ? light >= leastLight : light <= mostLight;
  };
  while (!table_->diverging && first_ < 0.5 && !standsOut(first_)) first_ += 1.0 / colorSteps;
  while (!table_->diverging && last_ > 0.5 && !standsOut(last_)) last_ -= 1.0 / colorSteps;
  if (turned) std::swap(first_, last_);
}

QColor VectorColors::at(double value) const {
  const double share = end_ > begin_ ? std::clamp((value - begin_) / (end_ - begin_), 0.0, 1.0) : 0.0;
  const ColorTable::Rgb color = table_->at(first_ + share * (last_ - first_));
  const double shade = 1.0 - (1.0 - shade_) * (1.0 - std::abs(2.0 * share - 1.0));
  return QColor::fromRgbF(shade * color[0], shade * color[1], shade * color[2]);
}

}  // namespace mien
