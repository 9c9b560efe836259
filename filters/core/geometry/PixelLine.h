#pragma once

#include <algorithm>
#include <cstddef>

namespace mien {

/// A line of pixels as the function whose mean over each pixel is that pixel's value: a parabola per pixel, continuous
/// where pixels meet. Its mean over any stretch is exact coverage where many pixels make one, and smooth where one
/// makes many; over a pixel itself it is that pixel again. Beyond its ends the line repeats its first and last pixel.
///
/// Pixels have `channels` values each, stored together; Value is float or double.
template <typename Value>
class PixelLine {
 public:
  PixelLine(const Value* pixels, int count, int channels) : pixels_(pixels), count_(count), channels_(channels) {}

  /// The mean over every stretch between neighbouring borders (pixels, not descending), channels together.
  void means(const double* borders, int stretches, Value* result) const {
    if (channels_ == 1) return run<1>(borders, stretches, result);
    if (channels_ == 3) return run<3>(borders, stretches, result);
    if (channels_ == 4) return run<4>(borders, stretches, result);
    run<0>(borders, stretches, result);
  }

 private:
  static constexpr double narrowest = 1e-3;  ///< stretch whose mean is the value in its middle, pixels

  /// The loops over channels are unrolled for pictures of the usual kinds; 0: any number.
  template <int Fixed>
  int channels() const {
    return Fixed > 0 ? Fixed : channels_;
  }

  template <int Fixed>
  void run(const double* borders, int stretches, Value* result) const {
    for (int i = 0; i < stretches; ++i, result += channels<Fixed>()) mean<Fixed>(borders[i], borders[i + 1], result);
  }

  int pixelAt(double x) const { return static_cast<int>(std::clamp(x, 0.0, count_ - 1.0)); }
  const Value* pixel(int i) const {
    return pixels_ + static_cast<std::ptrdiff_t>(std::clamp(i, 0, count_ - 1)) * channels_;
  }

  /// The parabola of one pixel in one channel.
  struct Piece {
    Value left, bend, curve;
    Piece(Value before, Value here, Value after) {
      const Value l = (before + here) / 2, r = (here + after) / 2;
      left = l;
      bend = 6 * here - 4 * l - 2 * r;
      curve = 3 * (l + r) - 6 * here;
    }
    Value at(Value t) const { return left + t * (bend + t * curve); }
    Value integral(Value t) const { return t * (left + t * (bend / 2 + t * (curve / 3))); }
  };

  template <int Fixed>
  void mean(double begin, double end, Value* result) const {
    if (end - begin < narrowest) return point<Fixed>(0.5 * (begin + end), result);
    const double length = end - begin;
    begin = std::clamp(begin, 0.0, static_cast<double>(count_));
    end = std::clamp(end, 0.0, static_cast<double>(count_));
    if (end - begin < length) return point<Fixed>(0.5 * (begin + end), result);
    const int first = pixelAt(begin), last = pixelAt(end);
    const Value from = static_cast<Value>(begin - first), to = static_cast<Value>(end - last),
                scale = static_cast<Value>(1.0 / length);
    const Value *before = pixel(first - 1), *here = pixel(first), *after = pixel(first + 1);
    for (int c = 0; c < channels<Fixed>(); ++c) result[c] = -Piece(before[c], here[c], after[c]).integral(from);
    for (int i = first; i < last; ++i)
      for (int c = 0; c < channels<Fixed>(); ++c)
        result[c] += pixels_[static_cast<std::ptrdiff_t>(i) * channels<Fixed>() + c];
    before = pixel(last - 1), here = pixel(last), after = pixel(last + 1);
    for (int c = 0; c < channels<Fixed>(); ++c)
      result[c] = (result[c] + Piece(before[c], here[c], after[c]).integral(to)) * scale;
  }

  template <int Fixed>
  void point(double x, Value* result) const {
    const int i = pixelAt(x);
    const Value t = static_cast<Value>(std::clamp(x - i, 0.0, 1.0));
    const Value *before = pixel(i - 1), *here = pixel(i), *after = pixel(i + 1);
    for (int c = 0; c < channels<Fixed>(); ++c) result[c] = Piece(before[c], here[c], after[c]).at(t);
  }

  const Value* pixels_;
  int count_, channels_;
};

}  // namespace mien
