#pragma once

#include <string>

#include "ClosedCurves.h"
#include "FaceSurface.h"
#include "PDESurface.h"

/// A surface of the core with its output: points and normals in single precision, N = 5, written again for every frame.
class FrameSurface {
 public:
  static constexpr int usualRows = 56, usualColumns = 40;

  explicit FrameSurface(const std::string& scheme, int rows = usualRows, int columns = usualColumns)
      : surface_(piecesOf(scheme, rows), mien::HarmonicSplit(40, 5, true), mien::FaceLayout::curveCount,
                 Eigen::VectorXd::LinSpaced(columns + 1, 0.0, 2.0 * M_PI)),
        points_(mien::RowMajor<float>::Zero(rows, 3 * (columns + 1))),
        normals_(points_) {}

  void update(const mien::ClosedCurves& curves) {
    surface_.setCurves(curves);
    surface_.evaluateWithNormals(0, gridOf(points_), gridOf(normals_));
  }

  const mien::RowMajor<float>& points() const { return points_; }

 private:
  using Grid = mien::PDESurface<float>::Grid;
  static Grid gridOf(mien::RowMajor<float>& all) { return Grid(all.data(), all.rows(), all.cols()); }

  static std::vector<mien::SurfacePiece> piecesOf(const std::string& scheme, int rows) {
    mien::FaceSurfaceOptions options;
    options.scheme = scheme;
    return facePieces(options, mien::RowLayout(rows, false));
  }

  mien::PDESurface<float> surface_;
  mien::RowMajor<float> points_, normals_;
};
