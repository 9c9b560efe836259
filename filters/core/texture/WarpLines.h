#pragma once

#include <cstddef>
#include <vector>

#include "MeshWarp.h"
#include "PixelLine.h"
#include "SmoothStep.h"

namespace mien {

/// A run of pixels that is wanted of a line.
struct PixelRange {
  int first = 0, count = 0;
};

/// Colours beside the mesh, where an image is wrapped around a head: from the colour at the mesh's right border, around
/// the closing column, to that at its left border. Away from the border it is the mean over a part of the row within,
/// which draws no streaks.
template <typename Value>
void closeRow(const MeshWarp& warp, int row, const PixelLine<Value>& line, int channels, PixelRange range,
              Value* warped) {
  constexpr double averaged = 0.02, goneOver = 0.08;  // of the mesh's width; of the way around
  const double left = warp.firstColumnAt(row), right = warp.lastColumnAt(row), width = warp.warpedSize().width;
  const double from = warp.firstSourceAt(row), to = warp.lastSourceAt(row), part = averaged * (to - from);
  std::vector<Value> colours(4 * channels);  // right: border, mean; left: mean, border
  const double stretches[4][2] = {{to, to}, {to - part, to}, {from, from + part}, {from, from}};
  for (int i = 0; i < 4; ++i) line.means(stretches[i], 1, colours.data() + i * channels);
  for (int i = 0; i < range.count; ++i) {
    const double x = range.first + i + 0.5;
    if (x >= left && x <= right) continue;
    const double way = wayAround(x, left, right, width);
    const double places[4] = {0.0, goneOver, 1.0 - goneOver, 1.0};
    const int k = way < places[1] ? 0 : way < places[2] ? 1 : 2;
    const Value share = static_cast<Value>(smoothStep((way - places[k]) / (places[k + 1] - places[k])));
    const Value* colour = colours.data() + k * channels;
    for (int c = 0; c < channels; ++c)
      warped[static_cast<std::ptrdiff_t>(i) * channels + c] = colour[c] + share * (colour[channels + c] - colour[c]);
  }
}

/// First pass of MeshWarp: pixels range of the warped image's width from a row of the source. Value is float or double.
template <typename Value>
void warpRow(const MeshWarp& warp, int row, const Value* pixels, int channels, bool closed, PixelRange range,
             Value* warped) {
  thread_local std::vector<double> borders;
  borders.resize(range.count + 1);
  warp.rowBorders(row, range.first, range.count + 1, borders.data());
  const PixelLine<Value> line(pixels, warp.sourceSize().width, channels);
  line.means(borders.data(), range.count, warped);
  if (closed) closeRow(warp, row, line, channels, range, warped);
}

/// Second pass: pixels range of the warped image's height from a column that the first pass made.
template <typename Value>
void warpColumn(const MeshWarp& warp, int column, const Value* pixels, int channels, PixelRange range, Value* warped) {
  thread_local std::vector<double> borders;
  borders.resize(range.count + 1);
  warp.columnBorders(column, range.first, range.count + 1, borders.data());
  PixelLine<Value>(pixels, warp.sourceSize().height, channels).means(borders.data(), range.count, warped);
}

}  // namespace mien
