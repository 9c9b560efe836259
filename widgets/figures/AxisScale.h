#pragma once

#include "ChartAxis.h"

namespace mien {

/// A place on an axis; minor ones have no text.
struct AxisTick {
  double value;
  std::string text;
};

/// Where a value lies along an axis, and which values are worth a tick.
class AxisScale {
 public:
  AxisScale() = default;
  AxisScale(double begin, double end, bool logarithmic) : begin_(begin), end_(end), logarithmic_(logarithmic) {}

  /// The scale that shows all finite values; `withZero` for bars, which grow from 0 on a linear axis.
  static AxisScale around(const ChartAxis& axis, const std::vector<double>& values, bool withZero);

  double begin() const { return begin_; }
  double end() const { return end_; }
  bool logarithmic() const { return logarithmic_; }

  /// 0 at the beginning, 1 at the end. On a logarithmic axis what is not positive lies at the beginning.
  double fraction(double value) const;

  /// Where bars stand on.
  double base() const { return logarithmic_ ? begin_ : 0.0; }

  /// About `most` labelled ticks but at least two, and the minor ones of a logarithmic axis.
  std::vector<AxisTick> ticks(const ChartAxis& axis, int most) const;

 private:
  std::vector<AxisTick> linearTicks(double step, double origin) const;
  std::vector<AxisTick> decadeTicks(int most) const;
  std::vector<AxisTick> evenTicks(int most) const;

  double begin_ = 0.0, end_ = 1.0;
  bool logarithmic_ = false;
};

/// A number as it stands at an axis: "0.25", "−40", "10⁻⁶"; `step` tells the decimals that are needed.
std::string tickText(double value, double step);

}  // namespace mien
