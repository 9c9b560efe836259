#pragma once

#include <cmath>
#include <random>

#include "ClosedCurves.h"
#include "FaceCurves.h"
#include "FaceLayout.h"

/// A head-like stack of closed curves with random harmonics of every order: no symmetry, no smoothness to lean on.
/// The lips (curves 21 and 22) coincide.
inline mien::FaceCurves randomFace(int pointsPerCurve = 40, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  mien::FaceCurves face;
  face.curves = mien::ClosedCurves(mien::FaceLayout::curveCount, pointsPerCurve);
  for (int c = 0; c < mien::FaceLayout::curveCount; ++c) {
    const double height = 100.0 - 7.0 * (c > mien::FaceLayout::upperLip ? c - 1 : c);
    for (int j = 0; j < pointsPerCurve; ++j) {
      const double v = 2.0 * M_PI * j / pointsPerCurve;
      const double radius = 80.0 + 3.0 * noise(random);
      face.curves.curve(c).row(j) << -radius * std::sin(v), height + noise(random), -radius * std::cos(v);
    }
  }
  face.curves.curve(mien::FaceLayout::lowerLip) = face.curves.curve(mien::FaceLayout::upperLip);
  return face;
}

/// The size by which errors of lengths are judged: the largest coordinate.
inline double sizeOf(const mien::ClosedCurves& curves) {
  return curves.points.cwiseAbs().maxCoeff();
}
