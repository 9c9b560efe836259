#include "PDESurface.h"

#include "FaceSurface.h"
#include "RandomCurves.h"
#include "SharedDerivatives.h"
#include "SurfaceNormals.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace mien;

namespace {

Eigen::VectorXd columns(int count) {
  return Eigen::VectorXd::LinSpaced(count, 0.0, 2.0 * M_PI * (count - 1) / count);
}

PDESurface<double> makeFace(const FaceSurfaceOptions& options, int rows, int pointsPerCurve, const Eigen::VectorXd& v) {
  const HarmonicSplit split(pointsPerCurve, options.modes, options.remainder);
  return PDESurface<double>(facePieces(options, RowLayout(rows, false)), split, FaceLayout::curveCount, v);
}

RowMajor<double> positions(const PDESurface<double>& surface) {
  RowMajor<double> grid(surface.rowCount(), 3 * surface.columnCount());
  surface.position(0, {grid.data(), grid.rows(), grid.cols()});
  return grid;
}

RowMajor<double> derivativesU(const PDESurface<double>& surface) {
  RowMajor<double> grid(surface.rowCount(), 3 * surface.columnCount());
  surface.derivativeU(0, {grid.data(), grid.rows(), grid.cols()});
  return grid;
}

RowMajor<double> derivativesV(const PDESurface<double>& surface) {
  RowMajor<double> grid(surface.rowCount(), 3 * surface.columnCount());
  surface.derivativeV(0, {grid.data(), grid.rows(), grid.cols()});
  return grid;
}

/// The row of a 27 k + 2 grid that lies on a curve.
int rowOfCurve(int curve, int rows) {
  const int k = (rows - 2) / 27;
  return curve <= FaceLayout::upperLip ? curve * k : (curve - 1) * k + 1;
}

double largestMiss(const RowMajor<double>& grid, int row, const ClosedCurves& curves, int curve) {
  double miss = 0.0;
  for (int j = 0; j < curves.pointsPerCurve; ++j)
    miss = std::max(miss, (grid.block<1, 3>(row, 3 * j) - curves.curve(curve).row(j)).cwiseAbs().maxCoeff());
  return miss;
}

}  // namespace

TEST(PDESurface, FourCurveFaceMeetsEveryCurveAtEverySampleForEveryNumberOfModes) {
  const FaceCurves face = randomFace();
  for (int modes = 0; modes <= 20; ++modes) {
    FaceSurfaceOptions options;
    options.modes = modes;
    PDESurface<double> surface = makeFace(options, 29, 40, columns(40));
    surface.setCurves(face.curves);
    const RowMajor<double> grid = positions(surface);
    for (int c = 0; c < FaceLayout::curveCount; ++c)
      EXPECT_LE(largestMiss(grid, rowOfCurve(c, 29), face.curves, c), 1e-12 * sizeOf(face.curves)) << "N " << modes << " curve " << c;
  }
}

TEST(PDESurface, WithoutTheRemainderCurvesAreMissed) {
  const FaceCurves face = randomFace();
  FaceSurfaceOptions options;
  options.remainder = false;
  PDESurface<double> surface = makeFace(options, 29, 40, columns(40));
  surface.setCurves(face.curves);
  EXPECT_GT(largestMiss(positions(surface), 0, face.curves, 0), 0.1);
  options.modes = 20;
  PDESurface<double> complete = makeFace(options, 29, 40, columns(40));
  complete.setCurves(face.curves);
  EXPECT_LE(largestMiss(positions(complete), 0, face.curves, 0), 1e-12 * sizeOf(face.curves));
}

TEST(PDESurface, DerivativeFaceMeetsItsEndsAndItsSlopesUpToTheLargestSmoothing) {
  const FaceCurves face = randomFace();
  const Eigen::MatrixXd slope = sharedDerivatives(1);
  for (const double a : {0.01, 1.0, 30.0, 1000.0}) {
    FaceSurfaceOptions options;
    options.scheme = "derivative";
    options.smoothing.fill(a);
    PDESurface<double> surface = makeFace(options, 29, 40, columns(40));
    surface.setCurves(face.curves);
    const RowMajor<double> grid = positions(surface), su = derivativesU(surface);
    for (const int first : FaceLayout::firstCurve) {
      const int last = first + 3;
      EXPECT_LE(largestMiss(grid, rowOfCurve(last, 29), face.curves, last), 1e-12 * sizeOf(face.curves)) << a;
      ClosedCurves expected(1, 40);
      for (int c = 0; c < FaceLayout::curveCount; ++c) expected.curve(0) += slope(last, c) * face.curves.curve(c);
      EXPECT_LE(largestMiss(su, rowOfCurve(last, 29), expected, 0), 1e-12 * (1.0 + 6.0 * a) * sizeOf(expected)) << a;
    }
  }
}

// e^(anu) (1 + u) cos(nv) and the like solve the equation, so curves cut from one patch-wide solution give it back.
TEST(PDESurface, ExactSolutionComesBackBetweenCurvesAndSamples) {
  for (const double a : {0.3, 1.0, 4.0}) {
    const auto exact = [a](double u, double v) {
      const double n2 = 2.0 * a, n5 = 5.0 * a;
      return Eigen::RowVector3d(std::exp(-n2 * u) * (1 + 3 * u) * std::cos(2 * v), u * std::exp(n5 * (u - 1)) * std::sin(5 * v),
                                4 + 3 * u - u * u + 2 * u * u * u);
    };
    ClosedCurves curves(4, 16);
    for (int c = 0; c < 4; ++c)
      for (int j = 0; j < 16; ++j) curves.curve(c).row(j) = exact(c / 3.0, 2 * M_PI * j / 16);
    SurfacePiece piece;
    piece.conditions = findFaceScheme("four-curve")->pieces[0].conditions;
    piece.smoothing = a;
    piece.boundaryData = [](int) { return Eigen::MatrixXd::Identity(4, 4).eval(); };
    for (int i = 0; i <= 50; ++i) piece.u.push_back(i / 50.0);
    PDESurface<double> surface({piece}, HarmonicSplit(16, 5, true), 4, columns(37));
    surface.setCurves(curves);
    const RowMajor<double> grid = positions(surface);
    const double tolerance = 1e-12 * (1 + lebesgueConstant(piece, HarmonicSplit(16, 5, true)));
    for (int row = 0; row < grid.rows(); ++row)
      for (int i = 0; i < 37; ++i)
        EXPECT_LE((grid.block<1, 3>(row, 3 * i) - exact(piece.u[row], columns(37)[i])).cwiseAbs().maxCoeff(), tolerance);
  }
}

TEST(PDESurface, DerivativesAreThoseOfTheSurface) {
  const FaceCurves face = randomFace();
  const int rows = 27 * 200 + 2, row = 1003;
  const double step = 1.0 / 600.0, turn = 1e-4;
  FaceSurfaceOptions options;
  Eigen::VectorXd v(3);
  v << 1.0 - turn, 1.0, 1.0 + turn;
  PDESurface<double> surface = makeFace(options, rows, 40, v);
  surface.setCurves(face.curves);
  const RowMajor<double> s = positions(surface), su = derivativesU(surface), sv = derivativesV(surface);
  const Eigen::RowVector3d differenceU = (s.block<1, 3>(row + 1, 3) - s.block<1, 3>(row - 1, 3)) / (2 * step);
  const Eigen::RowVector3d differenceV = (s.block<1, 3>(row, 6) - s.block<1, 3>(row, 0)) / (2 * turn);
  // central differences of second order: the error is the step squared times a third derivative of order 1e4
  EXPECT_LE((su.block<1, 3>(row, 3) - differenceU).norm(), 1e-3 * differenceU.norm());
  EXPECT_LE((sv.block<1, 3>(row, 3) - differenceV).norm(), 1e-4 * differenceV.norm());
}

TEST(PDESurface, NormalsPointOutwards) {
  FaceCurves face = randomFace();
  for (int c = 0; c < FaceLayout::curveCount; ++c)
    for (int j = 0; j < 40; ++j) {
      const double v = 2 * M_PI * j / 40;
      const double height = face.curves.curve(c).col(1).mean();
      face.curves.curve(c).row(j) << -80 * std::sin(v), height, -80 * std::cos(v);
    }
  PDESurface<double> surface = makeFace({}, 56, 40, columns(40));
  surface.setCurves(face.curves);
  RowMajor<double> s = positions(surface), su = derivativesU(surface), sv = derivativesV(surface), normals(s.rows(), s.cols());
  using Grid = PDESurface<double>::Grid;
  surfaceNormals<double>(Grid(su.data(), su.rows(), su.cols()), Grid(sv.data(), sv.rows(), sv.cols()), Grid(normals.data(), s.rows(), s.cols()));
  for (int row = 0; row < s.rows(); ++row)
    for (int i = 0; i < 40; ++i) {
      const Eigen::RowVector3d outwards(s(row, 3 * i), 0.0, s(row, 3 * i + 2));
      EXPECT_NEAR((normals.block<1, 3>(row, 3 * i).dot(outwards.normalized())), 1.0, 0.02);
    }
}

TEST(PDESurface, IsLinearAndMovesWithItsCurves) {
  const FaceCurves a = randomFace(40, 1), b = randomFace(40, 2);
  ClosedCurves sum = a.curves;
  sum.points = 2.0 * a.curves.points - b.curves.points;
  sum.points.rowwise() += Eigen::RowVector3d(10, -20, 30);
  PDESurface<double> surface = makeFace({}, 56, 40, columns(40));
  const auto evaluate = [&](const ClosedCurves& curves) { surface.setCurves(curves); return positions(surface); };
  RowMajor<double> expected = 2.0 * evaluate(a.curves) - evaluate(b.curves);
  for (int i = 0; i < 40; ++i) expected.middleCols<3>(3 * i).rowwise() += Eigen::RowVector3d(10, -20, 30);
  EXPECT_LE((evaluate(sum) - expected).cwiseAbs().maxCoeff(), 1e-11);
}
