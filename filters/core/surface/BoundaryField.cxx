#include "BoundaryField.h"

#include "RowProduct.h"

namespace mien {

template <class Scalar>
BoundaryField<Scalar>::BoundaryField(const HarmonicSplit& split, const Eigen::VectorXd& v, int derivative)
    : split_(split) {
  const Eigen::MatrixXd all = split.synthesis(v, derivative);
  for (int part = 0; part < split.count(); ++part)
    synthesis_.push_back(all.middleCols(split.firstCoefficient(part), split.coefficientCount(part)));
}

template <class Scalar>
void BoundaryField<Scalar>::update(const Eigen::MatrixXd& coefficients) {
  const Eigen::Index columns = synthesis_.front().rows();
  const Eigen::Index padded = (3 * columns + rowProductPadding - 1) / rowProductPadding * rowProductPadding;
  if (matrix_.cols() != padded) matrix_.setZero(coefficients.cols() / 3 * split_.count(), padded);
  if (coefficients_.cols() != coefficients.cols() + rowProductPadding)
    coefficients_.setZero(coefficients.rows(), coefficients.cols() + rowProductPadding);
  coefficients_.leftCols(coefficients.cols()) = coefficients;
  sampled_.resize(columns, coefficients.cols());
  for (int part = 0; part < split_.count(); ++part) fillPart(part, static_cast<int>(coefficients.cols()) / 3);
}

template <class Scalar>
void BoundaryField<Scalar>::fillPart(int part, int curveCount) {
  const RowMajor<double>& synthesis = synthesis_[part];
  const int columns = static_cast<int>(synthesis.rows()), parts = split_.count();
  if (synthesis.cols() == 0) return;  // a remainder without harmonics stays zero
  rowProduct(synthesis.data(), columns, static_cast<int>(synthesis.cols()),
             coefficients_.row(split_.firstCoefficient(part)).data(), coefficients_.cols(), 3 * curveCount,
             sampled_.data(), sampled_.cols());
  for (int c = 0; c < curveCount; ++c) {
    Scalar* const row = matrix_.row(c * parts + part).data();
    for (int column = 0; column < columns; ++column)
      for (int xyz = 0; xyz < 3; ++xyz) row[3 * column + xyz] = static_cast<Scalar>(sampled_(column, 3 * c + xyz));
  }
}

void fourierCoefficients(const Eigen::MatrixXd& analysis, const ClosedCurves& curves, Eigen::MatrixXd& samples,
                         Eigen::MatrixXd& coefficients) {
  samples.resize(curves.pointsPerCurve, 3 * curves.count);
  for (int c = 0; c < curves.count; ++c) samples.middleCols<3>(3 * c) = curves.curve(c);
  coefficients.resize(samples.rows(), samples.cols());
  coefficients.noalias() = analysis * samples;
}

template class BoundaryField<float>;
template class BoundaryField<double>;

}  // namespace mien
