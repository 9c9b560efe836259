#include "FaceFeatures.h"

#include <array>
#include <cmath>
#include <utility>

#include "FaceLayout.h"

namespace mien {

namespace {

struct MidlinePlace {
  const char* id;
  const char* curve;
};

constexpr std::array<MidlinePlace, 10> midlinePlaces = {{
    {"2.1", "C28"},
    {"2.2", "C22"},
    {"2.3", "C22'"},
    {"2.10", "C26"},
    {"8.1", "C21"},
    {"8.2", "C23"},
    {"9.3", "C15"},
    {"9.12", "C12"},
    {"9.15", "C18"},
    {"11.1", "C1"},
}};

/// A pair of features: x is the mean of two landmarks' distances from the midline (times a factor).
struct PairPlace {
  const char* left;
  const char* right;
  const char* curve;
  int first, second;  // landmarks of the left side
  double factor;
};

constexpr int outerEye = 45, innerEye = 42;

constexpr std::array<PairPlace, 25> pairPlaces = {{
    {"2.4", "2.5", "C22", 64, 64, 1.0},
    {"2.6", "2.7", "C22", 64, 64, 0.5},    // halfway between 2.2 and 2.4
    {"2.8", "2.9", "C22'", 64, 64, 0.5},   // halfway between 2.3 and 2.4
    {"2.11", "2.12", "C27", 55, 54, 1.0},  // between 8.7 and 8.3
    {"2.13", "2.14", "C28", 12, 12, 1.0},
    {"3.1", "3.2", "C9", innerEye, outerEye, 1.0},
    {"3.3", "3.4", "C10", innerEye, outerEye, 1.0},
    {"3.7", "3.12", "C9", outerEye, outerEye, 1.0},
    {"3.9", "3.10", "C11", innerEye, outerEye, 1.0},
    {"3.11", "3.8", "C9", innerEye, innerEye, 1.0},
    {"3.13", "3.14", "C8", innerEye, outerEye, 1.0},
    {"4.1", "4.2", "C6", 22, 22, 1.0},
    {"4.3", "4.4", "C6", 22, 26, 1.0},  // halfway between 4.1 and 4.5
    {"4.5", "4.6", "C6", 26, 26, 1.0},
    {"5.1", "5.2", "C21", 54, 13, 1.0},  // between mouth corner and jaw
    {"5.3", "5.4", "C13", 46, 45, 1.0},  // between pupil and outer eye corner
    {"8.3", "8.4", "C22", 54, 54, 1.0},
    {"8.5", "8.6", "C21", 54, 54, 0.5},  // halfway between 8.1 and 8.3
    {"8.7", "8.8", "C23", 54, 54, 0.5},  // halfway between 8.2 and 8.3
    {"8.10", "8.9", "C21", 52, 52, 1.0},
    {"9.1", "9.2", "C17", 35, 35, 1.45},  // wings stand out beyond the nostrils' edge
    {"9.5", "9.4", "C18", 35, 35, 1.0},
    {"9.7", "9.6", "C9", innerEye, innerEye, 0.5},  // side walls of the nose bone
    {"9.13", "9.14", "C12", innerEye, innerEye, 0.5},
    {"11.3", "11.2", "C2", 25, 25, 1.0},  // beyond 4.3
}};

double distanceFromMidline(const FaceLandmarks& landmarks, int landmark) {
  return 0.5 * std::abs(landmarks[landmark].x() - landmarks[mirrorLandmark(landmark)].x());
}

/// Distance from the midline that the curve has at v, as the mean of both sides.
double halfWidth(const ClosedCurves& curves, int curve, double v) {
  return 0.5 * (curves.at(curve, v).x() - curves.at(curve, 2.0 * M_PI - v).x());
}

/// v in pi .. 2 pi where the half width is x; the widest point of the front when the curve is narrower than that.
double solveForWidth(const ClosedCurves& curves, int curve, double x) {
  constexpr int scanSteps = 200, bisections = 60;
  double low = M_PI, high = M_PI;
  for (int i = 1; i <= scanSteps && halfWidth(curves, curve, high) < x; ++i) {
    const double next = M_PI + M_PI * i / scanSteps;
    if (halfWidth(curves, curve, next) < halfWidth(curves, curve, high) && i > scanSteps / 2) return high;
    low = high;
    high = next;
  }
  for (int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (halfWidth(curves, curve, middle) < x ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void addPair(const PairPlace& place, const ClosedCurves& curves, const FaceLandmarks& landmarks,
             std::vector<FeaturePoint>& features) {
  const int curve = FaceLayout::curveIndex(place.curve);
  const double x =
      0.5 * place.factor * (distanceFromMidline(landmarks, place.first) + distanceFromMidline(landmarks, place.second));
  const double v = solveForWidth(curves, curve, x);
  features.push_back({place.left, curve, v});
  features.push_back({place.right, curve, 2.0 * M_PI - v});
}

}  // namespace

std::vector<FeaturePoint> locateFeatures(const ClosedCurves& curves, const FaceLandmarks& landmarks) {
  std::vector<FeaturePoint> features;
  for (const MidlinePlace& place : midlinePlaces)
    features.push_back({place.id, FaceLayout::curveIndex(place.curve), M_PI});
  for (const PairPlace& place : pairPlaces) addPair(place, curves, landmarks, features);
  return features;
}

}  // namespace mien
