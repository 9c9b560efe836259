#include "BoundaryData.h"

#include <algorithm>

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
    : split_(split), curveCount_(curveCount), combinations_(split.count(), RowMajor<double>(0, curveCount)) {}

int BoundaryData::position(const Datum& datum) {
  const int curve = plainCurve(datum);
  if (curve >= 0) return curve;
  std::vector<double> key;
  for (const Eigen::RowVectorXd& part : datum) key.insert(key.end(), part.data(), part.data() + part.size());
  const auto [found, isNew] = known_.emplace(key, count());
  if (isNew) combine(datum);
  return found->second;
}

void BoundaryData::combine(const Datum& datum) {
  for (size_t part = 0; part < datum.size(); ++part) {
    RowMajor<double>& all = combinations_[part];
    all.conservativeResize(all.rows() + 1, Eigen::NoChange);
    all.row(all.rows() - 1) = datum[part];
  }
  std::vector<int>& sources = sources_.emplace_back();
  for (int curve = 0; curve < curveCount_; ++curve)
    if (std::any_of(datum.begin(), datum.end(), [&](const auto& part) { return part[curve] != 0.0; }))
      sources.push_back(curve);
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

// A part's coefficients as one row a datum: those of a curve times the combinations are those of what follows from it.
void BoundaryData::derive(BoundaryCoefficients& coefficients) const {
  for (int part = 0; part < split_.count(); ++part) {
    const RowMajor<double>& combinations = combinations_[part];
    const int columns = 3 * split_.coefficientCount(part);
    double* const curves = coefficients.part(part);
    rowProduct(combinations.data(), static_cast<int>(combinations.rows()), curveCount_, curves, columns, columns,
               curves + static_cast<long>(curveCount_) * columns, columns);
  }
}

}  // namespace mien
