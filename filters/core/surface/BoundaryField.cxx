#include "BoundaryField.h"

#include "RowProduct.h"

namespace mien {

namespace {

/// The columns, and the first again as often as it takes: a vector's last lanes then hold numbers like all others.
Eigen::VectorXd padded(const Eigen::VectorXd& v, int count) {
  Eigen::VectorXd all = Eigen::VectorXd::Constant(count, v.size() > 0 ? v[0] : 0.0);
  all.head(v.size()) = v;
  return all;
}

}  // namespace

template <class Scalar>
BoundaryField<Scalar>::BoundaryField(const HarmonicSplit& split, const Eigen::VectorXd& v, int derivative)
    : split_(split), columns_(static_cast<int>(v.size())) {
  const int count = AlignedRows<Scalar>::paddedCount(columns_);
  const Eigen::MatrixXd all = split.synthesis(padded(v, count), derivative);
  for (int part = 0; part < split.count(); ++part) {
    AlignedRows<Scalar>& synthesis = synthesis_.emplace_back(split.coefficientCount(part), count);
    for (int k = 0; k < synthesis.rows(); ++k)
      for (int i = 0; i < count; ++i)
        synthesis.row(k)[i] = static_cast<Scalar>(all(i, split.firstCoefficient(part) + k));
  }
}

template <class Scalar>
void BoundaryField<Scalar>::update(const Scalar* coefficients, int dataCount) {
  const int rows = 3 * dataCount;
  matrix_.resize(rows * split_.count(), columns_);
  for (int part = 0; part < split_.count(); ++part) {
    const AlignedRows<Scalar>& synthesis = synthesis_[part];
    if (synthesis.rows() == 0) continue;  // a remainder without harmonics stays zero
    rowProduct(coefficients + static_cast<long>(rows) * split_.firstCoefficient(part), rows, synthesis.rows(),
               synthesis.row(0), synthesis.stride(), static_cast<int>(synthesis.stride()), matrix_.row(part * rows),
               matrix_.stride());
  }
}

template class BoundaryField<float>;
template class BoundaryField<double>;

}  // namespace mien
