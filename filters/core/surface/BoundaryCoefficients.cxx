#include "BoundaryCoefficients.h"

#include "RowProduct.h"

namespace mien {

BoundaryCoefficients::BoundaryCoefficients(const HarmonicSplit& split, int curveCount, int dataCount)
    : split_(split),
      curveCount_(curveCount),
      dataCount_(dataCount),
      analysis_(split.pointsPerCurve(), split.pointsPerCurve()),
      samples_(3 * curveCount, split.pointsPerCurve()),
      ofCurves_(3 * curveCount, split.pointsPerCurve()),
      values_(3L * dataCount * split.pointsPerCurve() + rowProductPadding, 0.0) {
  const Eigen::MatrixXd analysis = split.analysis();
  for (int sample = 0; sample < analysis.cols(); ++sample)
    for (int k = 0; k < analysis.rows(); ++k) analysis_.row(sample)[k] = analysis(k, sample);
}

void BoundaryCoefficients::setCurves(const ClosedCurves& curves) {
  const int count = split_.pointsPerCurve(), rows = 3 * curveCount_;
  for (int c = 0; c < curveCount_; ++c) samples_.middleRows<3>(3 * c) = curves.curve(c).transpose();
  rowProduct(samples_.data(), rows, count, analysis_.row(0), analysis_.stride(), count, ofCurves_.data(), count);
  for (int j = 0; j < split_.count(); ++j) {
    const int columns = split_.coefficientCount(j);
    double* out = part(j);
    for (int row = 0; row < rows; ++row, out += columns)
      Eigen::Map<Eigen::RowVectorXd>(out, columns) = ofCurves_.row(row).segment(split_.firstCoefficient(j), columns);
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
