#include "SameCurves.h"

namespace mien {

namespace {

constexpr double rounding = 1e-3;  // mm

}  // namespace

bool areSameCurves(const ClosedCurves& one, const ClosedCurves& other) {
  return one.count == other.count && one.pointsPerCurve == other.pointsPerCurve &&
         ((one.points - other.points).array().abs() <= rounding).all();
}

}  // namespace mien
