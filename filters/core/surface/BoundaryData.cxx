#include "BoundaryData.h"

#include "RowProduct.h"

namespace mien {

namespace {

/// The curve that a combination takes as it is, or -1.
int plainCurve(const std::vector<Eigen::RowVectorXd>& datum) {
  Eigen::Index curve = 0;
  datum.front().cwiseAbs().maxCoeff(&curve);
  for (const Eigen::RowVectorXd& part : datum)
    if (part != Eigen::RowVectorXd::Unit(part.size(), curve)) return -1;
  return static_cast<int>(curve);
}

}  // namespace

BoundaryData::BoundaryData(const HarmonicSplit& split, int curveCount)
    : split_(split), curveCount_(curveCount), combinations_(split.count(), Combinations(0, curveCount)) {}

int BoundaryData::position(const Datum& datum) {
  std::vector<double> key;
  for (const Eigen::RowVectorXd& part : datum) key.insert(key.end(), part.data(), part.data() + part.size());
  const auto [found, isNew] = known_.emplace(key, count());
  if (!isNew) return found->second;
  curve_.push_back(plainCurve(datum));
  if (curve_.back() < 0) combine(datum);
  return found->second;
}

void BoundaryData::combine(const Datum& datum) {
  for (size_t part = 0; part < datum.size(); ++part) {
    Combinations& all = combinations_[part];
    all.conservativeResize(all.rows() + 1, Eigen::NoChange);
    all.row(all.rows() - 1) = datum[part];
  }
  derived_.resize(combinations_.front().rows(), 3);
}

std::vector<int> BoundaryData::add(const SurfacePiece& piece) {
  std::vector<Datum> data(piece.conditions.size());
  for (int part = 0; part < split_.count(); ++part) {
    const Eigen::MatrixXd rows = dataOfConditions(piece, part);
    for (size_t i = 0; i < data.size(); ++i) data[i].push_back(rows.row(i));
  }
  std::vector<int> positions;
  for (const Datum& datum : data) positions.push_back(position(datum));
  return positions;
}

// Coefficient by coefficient: x, y, z of the curves become those of the data that follow from them.
void BoundaryData::derive(const Eigen::MatrixXd& curves, Eigen::MatrixXd& data) {
  const int derived = static_cast<int>(derived_.rows());
  const Eigen::Index padded = curves.cols() + rowProductPadding;
  if (rows_.rows() != curves.rows() || rows_.cols() != padded) rows_.setZero(curves.rows(), padded);
  rows_.leftCols(curves.cols()) = curves;
  data.resize(curves.rows(), 3 * count());
  for (int d = 0; d < count(); ++d)
    if (curve_[d] >= 0) data.middleCols<3>(3 * d) = curves.middleCols<3>(3 * curve_[d]);
  for (int part = 0; part < split_.count() && derived > 0; ++part)
    for (int k = split_.firstCoefficient(part), end = k + split_.coefficientCount(part); k < end; ++k) {
      rowProduct(combinations_[part].data(), derived, curveCount_, rows_.row(k).data(), 3, 3, derived_.data(), 3);
      for (int d = 0, row = 0; d < count(); ++d)
        if (curve_[d] < 0) data.block<1, 3>(k, 3 * d) = derived_.row(row++);
    }
}

}  // namespace mien
