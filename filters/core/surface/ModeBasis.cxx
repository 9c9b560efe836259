#include "ModeBasis.h"

#include <cmath>
#include <vector>

namespace mien {

namespace {

/// Highest derivative of a basis that is ever asked for, and the relative size below which a term of a series is left
/// out.
constexpr int largestDerivative = 16;
constexpr Extended negligibleTerm = 1e-36L;

/// Terms after which, at |u - 1/2| <= 1/2, all others are below 1e-30 of the sum: 70 at the largest rate and order 4.
int seriesLength(Extended rate, int order) {
  int length = 0;
  for (Extended term = 1; term > negligibleTerm; term *= rate / 2 / length) ++length;
  return length + order + largestDerivative;
}

/// x^n for small n >= 0.
Extended power(Extended x, int n) {
  Extended value = 1;
  for (int i = 0; i < n; ++i) value *= x;
  return value;
}

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
    sum +=
        binomial(derivative, l) * fallingFactorial(k, l) * power(rate * u, k - l) * (((derivative - l) % 2) ? -1 : 1);
  return sum * power(rate, derivative) * std::exp(-rate * u);
}

/// 1 / ((k + 1) (k + 2)), the step from one term of a series to the next but one.
const std::vector<Extended>& inversesOfSteps() {
  static const std::vector<Extended> inverses = [] {
    std::vector<Extended> all;
    for (int i = 0; i < 256; ++i) all.push_back(1.0L / ((i + 1.0L) * (i + 2.0L)));
    return all;
  }();
  return inverses;
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
  series_ = ExtendedMatrix::Zero(seriesLength(rate_, n), n);
  series_.topRows(n).setIdentity();
  std::vector<Extended> factors;
  for (int k = 0; k < half_; ++k) factors.push_back(binomial(half_, k) * power(-rate_ * rate_, half_ - k));
  for (int i = n; i < series_.rows(); ++i)
    for (int k = 0; k < half_; ++k) series_.row(i) -= factors[k] * series_.row(i - n + 2 * k);
}

// y_j^(i) is zero where i - j is odd, so that every column is a polynomial in (u - 1/2)^2, but for a factor u - 1/2.
ExtendedRow ModeBasis::seriesRow(Extended u, int derivative) const {
  const Extended s = u - 0.5L, squared = s * s;
  const int length = static_cast<int>(series_.rows());
  const std::vector<Extended>& inverses = inversesOfSteps();
  ExtendedRow row(order());
  for (int j = 0; j < order(); ++j) {
    const bool odd = (j + derivative) % 2 != 0;
    Extended sum = 0;
    for (int i = length - 1 - (length - 1 - j) % 2; i >= derivative; i -= 2)
      sum = series_(i, j) + sum * squared * inverses[i - derivative];
    row[j] = odd ? s * sum : sum;
  }
  return row;
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
