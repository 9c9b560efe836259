#include "FaceLandmarks.h"

#include <array>
#include <cmath>

namespace mien {

namespace {

constexpr double axisBehindEyes = 0.7;

struct Order {
  int upper, lower;
  const char* names;
};

/// What must lie above what; swapped or misnumbered landmarks break one of these.
constexpr std::array<Order, 7> orders = {{{19, 37, "the right brow above the right eye"},
                                          {24, 44, "the left brow above the left eye"},
                                          {27, 30, "the nose bridge above the nose tip"},
                                          {30, 33, "the nose tip above the nose base"},
                                          {33, 51, "the nose base above the upper lip"},
                                          {51, 57, "the upper lip above the lower lip"},
                                          {57, 8, "the lower lip above the chin"}}};

std::string describeSides(const FaceLandmarks& landmarks) {
  if (landmarks[36].x() < landmarks[45].x() && landmarks[48].x() < landmarks[54].x()) return {};
  return "landmarks 36 and 48 (the subject's right eye and mouth corner) must lie at smaller x than 45 and 54; +x is "
         "the "
         "subject's left";
}

}  // namespace

FacePose facePose(const FaceLandmarks& landmarks) {
  constexpr double leaning = 0.0267;  // of the line from chin to nose bridge
  const Eigen::Vector3d aside =
      landmarks[45] - landmarks[36] + landmarks[42] - landmarks[39] + landmarks[54] - landmarks[48];
  const Eigen::Vector3d up = landmarks[27] - landmarks[8];
  return {std::atan2(-aside.z(), aside.head<2>().norm()), std::atan2(up.z(), up.head<2>().norm()) - leaning};
}

HeadAxis headAxis(const FaceLandmarks& landmarks) {
  constexpr std::array<int, 8> midline = {27, 28, 29, 30, 33, 51, 57, 62};
  HeadAxis axis;
  for (const int i : midline) axis.x += landmarks[i].x() / midline.size();
  const Eigen::Vector3d right = landmarks[36], left = landmarks[45];
  axis.z = 0.5 * (left.z() + right.z()) - axisBehindEyes * (left - right).norm();
  return axis;
}

int mirrorLandmark(int landmark) {
  struct Range {
    int first, last, sum;  ///< landmark and mirror image add up to the sum
  };
  constexpr std::array<Range, 10> ranges = {{{0, 16, 16},
                                             {17, 26, 43},
                                             {31, 35, 66},
                                             {36, 39, 81},
                                             {42, 45, 81},
                                             {40, 41, 87},
                                             {46, 47, 87},
                                             {48, 54, 102},
                                             {55, 59, 114},
                                             {60, 64, 124}}};
  for (const Range& range : ranges)
    if (landmark >= range.first && landmark <= range.last) return range.sum - landmark;
  return landmark >= 65 ? 132 - landmark : landmark;
}

FaceLandmarks symmetrised(const FaceLandmarks& landmarks) {
  FaceLandmarks result;
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    const Eigen::Vector3d p = landmarks[i], q = landmarks[mirrorLandmark(i)];
    result.points.row(i) << 0.5 * (p.x() - q.x()), 0.5 * (p.y() + q.y()), 0.5 * (p.z() + q.z());
  }
  return result;
}

double eyeDistance(const FaceLandmarks& landmarks) {
  return (landmarks[45] - landmarks[36]).norm();
}

std::string describeFault(const FaceLandmarks& landmarks) {
  for (int i = 0; i < FaceLandmarks::count; ++i)
    if (!landmarks[i].allFinite()) return "landmark " + std::to_string(i) + " is not a finite position";
  for (const Order& order : orders)
    if (!(landmarks[order.upper].y() > landmarks[order.lower].y()))
      return "landmarks " + std::to_string(order.upper) + " and " + std::to_string(order.lower) + " do not have " +
             order.names + " (+y is up)";
  return describeSides(landmarks);
}

}  // namespace mien
