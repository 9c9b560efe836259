#include "HeadRotation.h"

#include <Eigen/Geometry>
#include <cmath>

#include "FAPUnit.h"

namespace mien {

namespace {

Eigen::Matrix3d turn(const FAPFrame& frame, int fap, const Eigen::Vector3d& axis) {
  const double value = frame.value(fap);
  return Eigen::AngleAxisd(std::isfinite(value) ? value * radiansPerAngleUnit : 0.0, axis).matrix();
}

}  // namespace

HeadRotation::HeadRotation(const FAPFrame& frame, const Eigen::Vector3d& centreOfRotation) : centre(centreOfRotation) {
  // x to the subject's left, y up, z forward: a positive turn about x takes z down, about y takes z to x, about z takes
  // the top of the head to -x, the subject's right.
  rotation = turn(frame, 49, Eigen::Vector3d::UnitY()) * turn(frame, 48, Eigen::Vector3d::UnitX()) *
             turn(frame, 50, Eigen::Vector3d::UnitZ());
}

bool HeadRotation::turns() const {
  return rotation != Eigen::Matrix3d::Identity();
}

void HeadRotation::apply(ClosedCurves::Points& points) const {
  if (!turns()) return;
  points = ((points.rowwise() - centre.transpose()) * rotation.transpose()).rowwise() + centre.transpose();
}

void HeadRotation::undo(ClosedCurves::Points& points) const {
  if (!turns()) return;
  points = ((points.rowwise() - centre.transpose()) * rotation).rowwise() + centre.transpose();
}

}  // namespace mien
