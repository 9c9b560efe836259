#include "MonotoneWalk.h"

namespace mien {

void MonotoneWalk::follow(double first, int places, double* result, std::ptrdiff_t resultStride) const {
  int i = 0;
  for (; i < places && first + i <= from(0); ++i, result += resultStride) *result = to(0);
  for (int k = 0; k < last_ && i < places; ++k) {
    if (first + i > from(k + 1)) continue;
    const Cubic cubic = piece(k);
    for (; i < places && first + i <= from(k + 1); ++i, result += resultStride) *result = cubic.at(first + i - from(k));
  }
  for (; i < places; ++i, result += resultStride) *result = to(last_);
}

double MonotoneWalk::slope(int k) const {
  if (k == 0) return rise(0);
  if (k == last_) return rise(last_ - 1);
  if (rise(k - 1) * rise(k) <= 0.0) return 0.0;
  const double before = 2.0 * width(k) + width(k - 1), after = width(k) + 2.0 * width(k - 1);
  return (before + after) / (before / rise(k - 1) + after / rise(k));
}

MonotoneWalk::Cubic MonotoneWalk::piece(int k) const {
  const double h = width(k), d = rise(k), begin = slope(k), end = slope(k + 1);
  return {to(k), begin, (3.0 * d - 2.0 * begin - end) / h, (begin + end - 2.0 * d) / (h * h)};
}

}  // namespace mien
