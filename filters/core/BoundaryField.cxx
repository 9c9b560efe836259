#include "BoundaryField.h"

#include "RowProduct.h"

namespace mien {

template <class Scalar>
BoundaryField<Scalar>::BoundaryField(const HarmonicSplit& split, const Eigen::VectorXd& v, int derivative)
    : split_(split), synthesis_(split.synthesis(v, derivative)) {}

template <class Scalar>
void BoundaryField<Scalar>::update(const Eigen::MatrixXd& coefficients) {
  const Eigen::Index padded = (3 * synthesis_.rows() + rowProductPadding - 1) / rowProductPadding * rowProductPadding;
  if (matrix_.cols() != padded) matrix_.setZero(coefficients.cols() / 3 * split_.count(), padded);
  for (int part = 0; part < split_.count(); ++part) fillPart(part, coefficients);
}

template <class Scalar>
void BoundaryField<Scalar>::fillPart(int part, const Eigen::MatrixXd& coefficients) {
  const int first = split_.firstCoefficient(part);
  const int count = split_.coefficientCount(part);
  sampled_.resize(synthesis_.rows(), coefficients.cols());
  sampled_.noalias() = synthesis_.middleCols(first, count) * coefficients.middleRows(first, count);
  const Eigen::Index curveCount = coefficients.cols() / 3;
  for (Eigen::Index c = 0; c < curveCount; ++c)
    for (Eigen::Index column = 0; column < sampled_.rows(); ++column)
      for (int xyz = 0; xyz < 3; ++xyz)
        matrix_(c * split_.count() + part, 3 * column + xyz) = static_cast<Scalar>(sampled_(column, 3 * c + xyz));
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
