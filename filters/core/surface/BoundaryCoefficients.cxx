#include "BoundaryCoefficients.h"

#include <algorithm>
#include <limits>

#include "RowProduct.h"

namespace mien {

BoundaryCoefficients::BoundaryCoefficients(const HarmonicSplit& split, int curveCount, int dataCount)
    : split_(split),
      curveCount_(curveCount),
      dataCount_(dataCount),
      analysis_(split.pointsPerCurve(), split.pointsPerCurve()),
      samples_(3 * curveCount, split.pointsPerCurve()),
      ofCurves_(3 * curveCount, split.pointsPerCurve()),
      values_(Eigen::ArrayXd::Zero(3L * dataCount * split.pointsPerCurve() + rowProductPadding)) {
  samples_.setConstant(std::numeric_limits<double>::quiet_NaN());  // equal to nothing: the first curves are all new
  changed_.reserve(curveCount);
  const Eigen::MatrixXd analysis = split.analysis();
  for (int sample = 0; sample < analysis.cols(); ++sample)
    for (int k = 0; k < analysis.rows(); ++k) analysis_.row(sample)[k] = analysis(k, sample);
}

const std::vector<DataRange>& BoundaryCoefficients::setCurves(const ClosedCurves& curves) {
  takeSamples(curves);
  for (const DataRange& changed : changed_) analyse(changed);
  return changed_;
}

void BoundaryCoefficients::takeSamples(const ClosedCurves& curves) {
  changed_.clear();
  for (int c = 0; c < curveCount_; ++c) {
    if (samples_.middleRows<3>(3 * c) == curves.curve(c).transpose()) continue;
    samples_.middleRows<3>(3 * c) = curves.curve(c).transpose();
    if (changed_.empty() || changed_.back().end < c) changed_.push_back({c, c});
    changed_.back().end = c + 1;
  }
}

void BoundaryCoefficients::analyse(const DataRange& changed) {
  const int count = split_.pointsPerCurve(), first = 3 * changed.first, rows = 3 * changed.count();
  rowProduct(samples_.row(first).data(), rows, count, analysis_.row(0), analysis_.stride(), count,
             ofCurves_.row(first).data(), count);
  for (int j = 0; j < split_.count(); ++j) {
    const int columns = split_.coefficientCount(j);
    const double* in = ofCurves_.row(first).data() + split_.firstCoefficient(j);
    double* out = part(j) + static_cast<long>(first) * columns;
    for (int row = 0; row < rows; ++row, in += count, out += columns) {
      if (columns > 0) out[0] = in[0];
      if (columns > 1) out[1] = in[1];  // most parts have two: a call would take longer
      if (columns > 2) std::copy(in + 2, in + columns, out + 2);
    }
  }
}

void fourierCoefficients(const Eigen::MatrixXd& analysis, const ClosedCurves& curves, Eigen::MatrixXd& samples,
                         Eigen::MatrixXd& coefficients) {
  samples.resize(curves.pointsPerCurve, 3 * curves.count);
  for (int c = 0; c < curves.count; ++c) samples.middleCols<3>(3 * c) = curves.curve(c);
  coefficients.resize(samples.rows(), samples.cols());
  coefficients.noalias() = analysis * samples;
}

}  // namespace mien
