#pragma once

#include <vector>

namespace mien {

/// Rows of numbers, each beginning where a cache line does and padded to whole lines: no vector is read from two.
template <class Scalar>
class AlignedRows {
 public:
  static constexpr int lineBytes = 64;
  static constexpr int numbersPerLine = lineBytes / static_cast<int>(sizeof(Scalar));

  static int paddedCount(int columns) { return (columns + numbersPerLine - 1) / numbersPerLine * numbersPerLine; }

  AlignedRows() = default;
  AlignedRows(int rows, int columns) { resize(rows, columns); }

  /// All numbers are 0 afterwards where the size changes; nothing happens where it does not.
  void resize(int rows, int columns) {
    if (rows == rows_ && paddedCount(columns) == stride_) return;
    rows_ = rows;
    stride_ = paddedCount(columns);
    lines_.assign(static_cast<std::size_t>(rows) * (stride_ / numbersPerLine), Line());
  }

  int rows() const { return rows_; }
  long stride() const { return stride_; }  ///< from one row to the next, the padded number of columns
  Scalar* row(int index) { return reinterpret_cast<Scalar*>(lines_.data()) + index * stride_; }
  const Scalar* row(int index) const { return reinterpret_cast<const Scalar*>(lines_.data()) + index * stride_; }

 private:
  struct alignas(lineBytes) Line {
    Scalar numbers[numbersPerLine] = {};
  };

  int rows_ = 0;
  long stride_ = 0;
  std::vector<Line> lines_;
};

}  // namespace mien
