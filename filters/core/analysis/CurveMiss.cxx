#include "CurveMiss.h"

#include "PDESurface.h"

namespace mien {

namespace {

/// Pieces whose rows are the 29 curves in their order: 27 intervals of rows, and the lips twice.
std::vector<SurfacePiece> piecesThroughCurves(const FaceSurfaceOptions& options) {
  return facePieces(options, RowLayout(FaceLayout::curveCount, false));
}

}  // namespace

double curveMiss(const FaceCurves& face, const FaceSurfaceOptions& options) {
  const int samples = face.curves.pointsPerCurve;
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(samples + 1, 0.0, 2.0 * M_PI).head(samples);
  const HarmonicSplit split(samples, options.modes, options.remainder);
  PDESurface<double> surface(piecesThroughCurves(options), split, FaceLayout::curveCount, v, 0);
  surface.setCurves(face.curves);
  RowMajor<double> rows(FaceLayout::curveCount, 3 * samples);
  surface.evaluate(0, 0, 0, PDESurface<double>::Grid(rows.data(), rows.rows(), rows.cols()));
  const Eigen::Map<const RowMajor<double>> curves(face.curves.points.data(), rows.rows(), rows.cols());
  return std::sqrt((rows - curves).squaredNorm() / (FaceLayout::curveCount * samples));
}

}  // namespace mien
