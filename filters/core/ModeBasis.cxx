#include "ModeBasis.h"

#include <cmath>

namespace mien {

namespace {

/// Terms of the power series: at |rate (u - 1/2)| <= 2.5 the last is below 1e-30 of the sum.
constexpr int seriesLength = 72;

Extended binomial(int n, int k) {
  Extended value = 1;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

/// n (n - 1) ... (n - k + 1).
Extended fallingFactorial(int n, int k) {
  Extended value = 1;
  for (int i = 0; i < k; ++i) value *= n - i;
  return value;
}

/// The derivative of that order of (rate u)^k e^(-rate u).
Extended decayingTerm(Extended rate, int k, Extended u, int derivative) {
  Extended sum = 0;
  for (int l = 0; l <= std::min(k, derivative); ++l)
    sum += binomial(derivative, l) * fallingFactorial(k, l) * std::pow(rate * u, k - l) * (((derivative - l) % 2) ? -1 : 1);
  return sum * std::pow(rate, derivative) * std::exp(-rate * u);
}

}  // namespace

ModeBasis::ModeBasis(double rate, int order) : rate_(rate), half_(order / 2) {
  if (rate <= largestSeriesRate) fillSeries();
}

ExtendedRow ModeBasis::row(Extended u, int derivative) const {
  return series_.size() ? seriesRow(u, derivative) : exponentialRow(u, derivative);
}

// The equation itself is the recursion: y^(i+2m) = - sum_k C(m,k) (-rate^2)^(m-k) y^(i+2k).
void ModeBasis::fillSeries() {
  const int n = order();
  series_ = ExtendedMatrix::Zero(seriesLength, n);
  series_.topRows(n).setIdentity();
  for (int i = n; i < seriesLength; ++i)
    for (int k = 0; k < half_; ++k)
      series_.row(i) -= binomial(half_, k) * std::pow(-rate_ * rate_, half_ - k) * series_.row(i - n + 2 * k);
}

ExtendedRow ModeBasis::seriesRow(Extended u, int derivative) const {
  const Extended s = u - 0.5L;
  ExtendedRow sum = ExtendedRow::Zero(order());
  for (int i = seriesLength - 1; i >= derivative; --i)
    sum = series_.row(i) + sum * (s / (i - derivative + 1));
  return sum;
}

ExtendedRow ModeBasis::exponentialRow(Extended u, int derivative) const {
  ExtendedRow values(order());
  const int mirrored = derivative % 2 ? -1 : 1;
  for (int k = 0; k < half_; ++k) {
    values[k] = decayingTerm(rate_, k, u, derivative);
    values[half_ + k] = mirrored * decayingTerm(rate_, k, 1 - u, derivative);
  }
  return values;
}

}  // namespace mien
