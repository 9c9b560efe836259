#include "CurveTransform.h"

#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace mien {

namespace {

using Spectrum = Eigen::VectorXcd;

Eigen::MatrixXd cosineBasis(int n) {
  Eigen::MatrixXd basis(n, n);
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) basis(k, i) = std::sqrt((k == 0 ? 1.0 : 2.0) / n) * std::cos(M_PI * (i + 0.5) * k / n);
  return basis;
}

/// From e^{-inv} to cos and sin of unit length.
Eigen::VectorXd realCoefficients(const Spectrum& spectrum, int k) {
  Eigen::VectorXd coefficients(k);
  const double scale = std::sqrt(2.0 / k), edge = std::sqrt(1.0 / k);
  coefficients[0] = edge * spectrum[0].real();
  for (int n = 1; n < k / 2; ++n) {
    coefficients[2 * n - 1] = scale * spectrum[n].real();
    coefficients[2 * n] = -scale * spectrum[n].imag();
  }
  coefficients[k - 1] = edge * spectrum[k / 2].real();
  return coefficients;
}

Spectrum complexCoefficients(const Eigen::VectorXd& coefficients) {
  const int k = static_cast<int>(coefficients.size());
  const double scale = std::sqrt(0.5 * k), edge = std::sqrt(1.0 * k);
  Spectrum spectrum(k / 2 + 1);
  spectrum[0] = edge * coefficients[0];
  for (int n = 1; n < k / 2; ++n)
    spectrum[n] = scale * std::complex<double>(coefficients[2 * n - 1], -coefficients[2 * n]);
  spectrum[k / 2] = edge * coefficients[k - 1];
  return spectrum;
}

}  // namespace

CurveTransform::CurveTransform(int curves, int pointsPerCurve)
    : pointsPerCurve_(pointsPerCurve), cosines_(cosineBasis(curves)) {}

Eigen::MatrixXd CurveTransform::forward(const Eigen::MatrixXd& values) const {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  Eigen::MatrixXd coefficients(values.rows(), pointsPerCurve_);
  Spectrum spectrum;
  for (Eigen::Index curve = 0; curve < values.rows(); ++curve) {
    const Eigen::VectorXd samples = values.row(curve);
    fft.fwd(spectrum, samples);
    coefficients.row(curve) = realCoefficients(spectrum, pointsPerCurve_).transpose();
  }
  return cosines_ * coefficients;
}

Eigen::MatrixXd CurveTransform::inverse(const Eigen::MatrixXd& coefficients) const {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  const Eigen::MatrixXd around = cosines_.transpose() * coefficients;
  Eigen::MatrixXd values(around.rows(), pointsPerCurve_);
  Eigen::VectorXd samples;
  for (Eigen::Index curve = 0; curve < around.rows(); ++curve) {
    fft.inv(samples, complexCoefficients(around.row(curve)), pointsPerCurve_);
    values.row(curve) = samples.transpose();
  }
  return values;
}

}  // namespace mien
