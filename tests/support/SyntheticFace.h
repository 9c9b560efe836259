#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "FaceCurves.h"
#include "FaceLayout.h"

/// A face of formulas, for tests: the layout and the feature points of the generic face on an ellipsoid-like
/// head. Eyes from x = 18 to 45 mm with a lid gap of 8 mm, a closed mouth from x = -25 to 25 mm.
class SyntheticFace {
 public:
  static mien::FaceCurves make(int pointsPerCurve = 40) {
    mien::FaceCurves face;
    face.curves = mien::ClosedCurves(mien::FaceLayout::curveCount, pointsPerCurve);
    for (int c = 0; c < face.curves.count; ++c)
      for (int j = 0; j < pointsPerCurve; ++j) face.curves.curve(c).row(j) = point(c, mirrorExact(j, pointsPerCurve));
    addFeatures(face);
    face.leftPupil = {31.5, 0.0, 85.0};
    face.rightPupil = {-31.5, 0.0, 85.0};
    face.hasPupils = true;
    return face;
  }

 private:
  /// v - pi, exactly opposite for mirrored samples.
  static double mirrorExact(int j, int k) { return 2.0 * M_PI * (j - k / 2) / k; }

  static Eigen::RowVector3d point(int curve, double t) {
    const double azimuth = t - 0.6 * std::sin(t);
    const double y = height(curve, 75.0 * std::sin(azimuth), std::abs(azimuth));
    const double radius = std::sqrt(1.0 - y * y / (160.0 * 160.0));
    return {75.0 * radius * std::sin(azimuth), y, 95.0 * radius * std::cos(azimuth)};
  }

  static double bump(double x, double from, double to) {
    return x <= from || x >= to ? 0.0 : std::sin(M_PI * (x - from) / (to - from));
  }

  /// Heights of the key curves at distance x from the middle, and the others evenly between.
  static double height(int curve, double x, double azimuth) {
    x = std::abs(x);
    const double eye = bump(x, 18.0, 45.0), mouth = bump(x + 25.0, 0.0, 50.0);
    const double lip = x < 25.0 ? 0.0 : std::min(x - 25.0, 20.0) * 0.2;
    const std::array<std::pair<int, double>, 12> keys = {{{0, 75.0},
                                                          {5, 20.0 + 3.0 * bump(x, 5.0, 55.0)},
                                                          {8, 1.0 + 3.0 * eye},
                                                          {9, -1.0 - 3.0 * eye},
                                                          {14, -32.0},
                                                          {17, -45.0},
                                                          {20, -64.0 + lip + 6.0 * mouth},
                                                          {21, -65.5},
                                                          {22, -65.5},
                                                          {23, -67.0 - lip - 8.0 * mouth},
                                                          {28, -110.0},
                                                          {28, -110.0}}};
    double y = keys[0].second;
    for (size_t i = 0; i + 1 < keys.size(); ++i)
      if (curve >= keys[i].first && curve <= keys[i + 1].first && keys[i].first < keys[i + 1].first)
        y = keys[i].second +
            (keys[i + 1].second - keys[i].second) * (curve - keys[i].first) / (keys[i + 1].first - keys[i].first);
    const double step = curve < 22 ? curve : curve - 1;
    const double even = 75.0 - 185.0 * step / 27.0;
    const double s = std::clamp((azimuth - 0.8) / 1.1, 0.0, 1.0);
    return y + (even - y) * s * s * (3.0 - 2.0 * s);
  }

  static double parameterAt(const mien::FaceCurves& face, int curve, double x) {
    double low = M_PI, high = 1.8 * M_PI;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const double width = 0.5 * (face.curves.at(curve, middle).x() - face.curves.at(curve, 2 * M_PI - middle).x());
      (width < x ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  static void addFeatures(mien::FaceCurves& face) {
    struct Place {
      const char *left, *right, *curve;
      double x;
    };
    for (const Place& p : {Place{"4.1", "4.2", "C6", 12.0},
                           {"4.3", "4.4", "C6", 32.0},
                           {"4.5", "4.6", "C6", 52.0},
                           {"3.1", "3.2", "C9", 31.5},
                           {"3.3", "3.4", "C10", 31.5},
                           {"9.1", "9.2", "C17", 16.0},
                           {"5.3", "5.4", "C13", 42.0},
                           {"8.3", "8.4", "C22", 26.0},
                           {"2.4", "2.5", "C22", 24.0},
                           {"5.1", "5.2", "C21", 48.0},
                           {"2.6", "2.7", "C22", 12.0},
                           {"2.8", "2.9", "C22'", 12.0},
                           {"8.5", "8.6", "C21", 13.0},
                           {"8.7", "8.8", "C23", 13.0}}) {
      const int curve = mien::FaceLayout::curveIndex(p.curve);
      const double v = parameterAt(face, curve, p.x);
      face.features.push_back({p.left, curve, v});
      face.features.push_back({p.right, curve, 2.0 * M_PI - v});
    }
    for (const auto& [id, curve] : {std::pair{"2.2", "C22"},
                                    {"2.3", "C22'"},
                                    {"8.1", "C21"},
                                    {"8.2", "C23"},
                                    {"9.3", "C15"},
                                    {"9.15", "C18"},
                                    {"2.1", "C28"},
                                    {"2.10", "C26"}})
      face.features.push_back({id, mien::FaceLayout::curveIndex(curve), M_PI});
  }
};
