#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "EvenColumns.h"
#include "FaceLebesgue.h"
#include "FaceSurface.h"
#include "PDESurface.h"
#include "RandomCurves.h"
#include "SharedDerivatives.h"
#include "SurfaceNormals.h"

using namespace mien;

namespace {

PDESurface<double> makeFace(const FaceSurfaceOptions& options, int rows, int pointsPerCurve, const Eigen::VectorXd& v) {
  const HarmonicSplit split(pointsPerCurve, options.modes, options.remainder);
  return PDESurface<double>(facePieces(options, RowLayout(rows, false)), split, FaceLayout::curveCount, v);
}

RowMajor<double> evaluate(const PDESurface<double>& surface, int orderU, int orderV) {
  RowMajor<double> grid(surface.rowCount(), 3 * surface.columnCount());
  surface.evaluate(orderU, orderV, 0, {grid.data(), grid.rows(), grid.cols()});
  return grid;
}

RowMajor<double> positions(const PDESurface<double>& surface) {
  return evaluate(surface, 0, 0);
}
RowMajor<double> derivativesU(const PDESurface<double>& surface) {
  return evaluate(surface, 1, 0);
}
RowMajor<double> derivativesV(const PDESurface<double>& surface) {
  return evaluate(surface, 0, 1);
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

namespace {

/// The largest distance between the curves of a four-curve face and its surface, over what the solution's condition
/// allows.
double fourCurveMiss(double a, int modes, int pointsPerCurve) {
  const FaceCurves face = randomFace(pointsPerCurve);
  FaceSurfaceOptions options;
  options.scheme = "four-curve";
  options.modes = modes;
  options.smoothing.fill(a);
  PDESurface<double> surface = makeFace(options, 29, pointsPerCurve, evenColumns(pointsPerCurve));
  surface.setCurves(face.curves);
  const RowMajor<double> grid = positions(surface);
  double miss = 0.0;
  for (int c = 0; c < FaceLayout::curveCount; ++c)
    miss = std::max(miss, largestMiss(grid, rowOfCurve(c, 29), face.curves, c));
  const double lebesgue = faceLebesgueConstant(options, HarmonicSplit(pointsPerCurve, modes, true));
  return miss / (sizeOf(face.curves) * (1.0 + lebesgue));
}

}  // namespace

TEST(PDESurface, FourCurveFaceMeetsEveryCurveAtEverySampleForEveryNumberOfModes) {
  for (const int pointsPerCurve : {16, 40, 64})
    for (const double a : {0.1, 1.0, 5.0})
      for (int modes = 0; modes <= pointsPerCurve / 2; ++modes)
        EXPECT_LE(fourCurveMiss(a, modes, pointsPerCurve), 1e-12)
            << "K " << pointsPerCurve << " a " << a << " N " << modes;
}

TEST(PDESurface, WithoutTheRemainderCurvesAreMissed) {
  const FaceCurves face = randomFace();
  FaceSurfaceOptions options;
  options.remainder = false;
  PDESurface<double> surface = makeFace(options, 29, 40, evenColumns(40));
  surface.setCurves(face.curves);
  EXPECT_GT(largestMiss(positions(surface), 0, face.curves, 0), 0.1);
  options.modes = 20;
  PDESurface<double> complete = makeFace(options, 29, 40, evenColumns(40));
  complete.setCurves(face.curves);
  EXPECT_LE(largestMiss(positions(complete), 0, face.curves, 0), 1e-12 * sizeOf(face.curves));
}

TEST(PDESurface, DerivativeFaceMeetsItsEndsAndItsSlopesUpToTheLargestSmoothing) {
  const FaceCurves face = randomFace();
  const Eigen::MatrixXd slope = sharedDerivatives(differenceDerivatives, 1, {});
  for (const double a : {0.01, 1.0, 30.0, 1000.0}) {
    FaceSurfaceOptions options;
    options.scheme = "derivative";
    options.smoothing.fill(a);
    PDESurface<double> surface = makeFace(options, 29, 40, evenColumns(40));
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
      return Eigen::RowVector3d(std::exp(-n2 * u) * (1 + 3 * u) * std::cos(2 * v),
                                u * std::exp(n5 * (u - 1)) * std::sin(5 * v), 4 + 3 * u - u * u + 2 * u * u * u);
    };
    ClosedCurves curves(4, 16);
    for (int c = 0; c < 4; ++c)
      for (int j = 0; j < 16; ++j) curves.curve(c).row(j) = exact(c / 3.0, 2 * M_PI * j / 16);
    SurfacePiece piece;
    piece.conditions = findFaceScheme("four-curve")->pieces[0].conditions;
    piece.smoothing = a;
    piece.boundaryData = [](int) { return Eigen::MatrixXd::Identity(4, 4).eval(); };
    for (int i = 0; i <= 50; ++i) piece.u.push_back(i / 50.0);
    PDESurface<double> surface({piece}, HarmonicSplit(16, 5, true), 4, evenColumns(37));
    surface.setCurves(curves);
    const RowMajor<double> grid = positions(surface);
    const double tolerance = 1e-12 * (1 + lebesgueConstant(piece, HarmonicSplit(16, 5, true)));
    for (int row = 0; row < grid.rows(); ++row)
      for (int i = 0; i < 37; ++i)
        EXPECT_LE((grid.block<1, 3>(row, 3 * i) - exact(piece.u[row], evenColumns(37)[i])).cwiseAbs().maxCoeff(),
                  tolerance);
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
  PDESurface<double> surface = makeFace({}, 56, 40, evenColumns(40));
  surface.setCurves(face.curves);
  RowMajor<double> s = positions(surface), su = derivativesU(surface), sv = derivativesV(surface),
                   normals(s.rows(), s.cols());
  using Grid = PDESurface<double>::Grid;
  surfaceNormals<double>(Grid(su.data(), su.rows(), su.cols()), Grid(sv.data(), sv.rows(), sv.cols()),
                         Grid(normals.data(), s.rows(), s.cols()));
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
  PDESurface<double> surface = makeFace({}, 56, 40, evenColumns(40));
  const auto evaluate = [&](const ClosedCurves& curves) {
    surface.setCurves(curves);
    return positions(surface);
  };
  RowMajor<double> expected = 2.0 * evaluate(a.curves) - evaluate(b.curves);
  for (int i = 0; i < 40; ++i) expected.middleCols<3>(3 * i).rowwise() += Eigen::RowVector3d(10, -20, 30);
  EXPECT_LE((evaluate(sum) - expected).cwiseAbs().maxCoeff(), 1e-11);
}

namespace {

/// The pieces of a face with the two ends of each as the only rows, so that seams are seen from both sides.
PDESurface<double> makeEnds(const FaceSurfaceOptions& options, const Eigen::VectorXd& v) {
  std::vector<SurfacePiece> pieces = facePieces(options, RowLayout(29, false));
  for (size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].u = {pieces[i].begin, pieces[i].end};
    pieces[i].firstRow = static_cast<int>(2 * i);
  }
  return PDESurface<double>(pieces, HarmonicSplit(40, options.modes, options.remainder), FaceLayout::curveCount, v, 2);
}

/// Largest difference across all borders between pieces, relative to the largest value.
double largestJump(const PDESurface<double>& surface, int orderU, int orderV) {
  const RowMajor<double> grid = evaluate(surface, orderU, orderV);
  double jump = 0.0;
  for (int row = 1; row + 1 < grid.rows(); row += 2)
    jump = std::max(jump, (grid.row(row) - grid.row(row + 1)).cwiseAbs().maxCoeff());
  return jump / grid.cwiseAbs().maxCoeff();
}

}  // namespace

// The lips coincide in these curves, so the seam of the closed mouth is one of the borders.
TEST(PDESurface, SmoothSchemesMeetEveryCurveAndHaveSmoothSeams) {
  const FaceCurves face = randomFace();
  for (const std::string scheme : {"tangent", "curvature", "spline"})
    for (const int modes : {0, 5, 20}) {
      FaceSurfaceOptions options;
      options.scheme = scheme;
      options.modes = modes;
      PDESurface<double> surface = makeFace(options, 29, 40, evenColumns(40));
      surface.setCurves(face.curves);
      const RowMajor<double> grid = positions(surface);
      for (int c = 0; c < FaceLayout::curveCount; ++c)
        EXPECT_LE(largestMiss(grid, rowOfCurve(c, 29), face.curves, c), 1e-10 * sizeOf(face.curves))
            << scheme << " N " << modes;
      PDESurface<double> ends = makeEnds(options, evenColumns(400));
      ends.setCurves(face.curves);
      EXPECT_LE(largestJump(ends, 0, 0), 1e-10) << scheme;
      EXPECT_LE(largestJump(ends, 1, 0), 1e-10) << scheme;
      if (scheme != "tangent") {
        EXPECT_LE(largestJump(ends, 2, 0), 1e-7) << scheme;
      }
    }
}

TEST(PDESurface, SeamsAreAsSmoothAsTheSchemeSaysAndNoSmoother) {
  const FaceCurves face = randomFace();
  const std::map<std::string, int> continuity = {{"four-curve", 0}, {"derivative", 1}, {"sixth-order", 2},
                                                 {"tangent", 1},    {"curvature", 2},  {"spline", 2}};
  for (const FaceScheme& scheme : faceSchemes()) {
    FaceSurfaceOptions options;
    options.scheme = scheme.name;
    PDESurface<double> ends = makeEnds(options, evenColumns(400));
    ends.setCurves(face.curves);
    for (int order = 0; order <= 2; ++order) {
      const double jump = largestJump(ends, order, 0);
      if (order <= continuity.at(scheme.name)) {
        EXPECT_LE(jump, 1e-9) << scheme.name << " order " << order;
      } else {
        EXPECT_GE(jump, 1e-3) << scheme.name << " order " << order;
      }
    }
  }
}

TEST(PDESurface, SplineStaysInsideItsCurvesAtEveryRate) {
  const FaceCurves face = randomFace();
  const Eigen::RowVector3d low = face.curves.points.colwise().minCoeff(),
                           high = face.curves.points.colwise().maxCoeff();
  const Eigen::RowVector3d middle = 0.5 * (low + high), half = 0.5 * (high - low);
  for (const double a : {0.01, 0.1, 1.0, 10.0, 100.0, 1000.0})
    for (const int modes : {0, 5, 20}) {
      FaceSurfaceOptions options;
      options.scheme = "spline";
      options.modes = modes;
      options.smoothing.fill(a);
      PDESurface<double> surface = makeFace(options, 27 * 6 + 2, 40, evenColumns(40));
      surface.setCurves(face.curves);
      const RowMajor<double> grid = positions(surface);
      double outside = 0.0;
      for (int row = 0; row < grid.rows(); ++row)
        for (int i = 0; i < 40; ++i)
          outside =
              std::max(outside, ((grid.block<1, 3>(row, 3 * i) - middle).cwiseAbs().cwiseQuotient(half)).maxCoeff());
      EXPECT_LE(outside, 1.03) << "a " << a << " N " << modes;
    }
}
