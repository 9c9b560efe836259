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
void BoundaryField<Scalar>::makeRoom(int dataCount, AlignedRows<Scalar>& b) const {
  b.resize(3 * dataCount * split_.count(), std::min(columns_, columnsOfStrip));
}

template <class Scalar>
void BoundaryField<Scalar>::sample(const Scalar* coefficients, int dataCount, const DataRange& data, int strip,
                                   AlignedRows<Scalar>& b) const {
  const int columns = AlignedRows<Scalar>::paddedCount(columnsOf(strip));
  for (int part = 0; part < split_.count(); ++part) {
    const AlignedRows<Scalar>& synthesis = synthesis_[part];
    Scalar* const out = b.row(3 * (part * dataCount + data.first));
    const long before = 3L * dataCount * split_.firstCoefficient(part) + 3L * data.first * synthesis.rows();
    if (synthesis.rows() == 0)  // a remainder without harmonics
      std::fill_n(out, 3 * data.count() * b.stride(), Scalar(0));
    else
      rowProduct(coefficients + before, 3 * data.count(), synthesis.rows(), synthesis.row(0) + strip * columnsOfStrip,
                 synthesis.stride(), columns, out, b.stride());
  }
}

template class BoundaryField<float>;
template class BoundaryField<double>;

}  // namespace mien
