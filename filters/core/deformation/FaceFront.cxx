#include "FaceFront.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "NumberText.h"

namespace mien {

namespace {

constexpr double depthOfEyes = 1.5;  // of the skin there from the pupils; the reference heads have 0.3 to 0.6

}  // namespace

std::string describeFront(const std::vector<Eigen::Vector3d>& places) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  double eyes = none;
  for (const Eigen::Vector3d& p : places) {
    if (std::abs(std::abs(p.x()) - 1.0) < 0.3 && std::abs(p.y()) < 0.3) eyes = std::max(eyes, p.z());
  }
  if (eyes != none && std::abs(eyes) > depthOfEyes)
    return "the foremost points at the pupils lie " + roundedText(std::abs(eyes)) + " pupil units " +
           (eyes > 0.0 ? "in front of" : "behind") +
           " them: the face looks backwards, or the pupils lack their depth; turn it to look along +z, and give the "
           "pupils as x,y,z,x,y,z";
  return {};
}

}  // namespace mien
