#include "FaceFront.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "NumberText.h"

namespace mien {

namespace {

constexpr double depthOfEyes = 1.5;    // of the skin there from the pupils; the reference heads have 0.3 to 0.6
constexpr double foreheadAhead = 0.2;  // of the nose; on the reference heads it is 0.6 to 0.9 behind

}  // namespace

std::string describeFront(const std::vector<Eigen::Vector3d>& places) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  double eyes = none, nose = none, forehead = none;
  for (const Eigen::Vector3d& p : places) {
    if (std::abs(std::abs(p.x()) - 1.0) < 0.3 && std::abs(p.y()) < 0.3) eyes = std::max(eyes, p.z());
    if (std::abs(p.x()) > 0.35) continue;
    if (p.y() < -0.5 && p.y() > -1.7) nose = std::max(nose, p.z());
    if (p.y() > 0.5 && p.y() < 1.7) forehead = std::max(forehead, p.z());
  }
  if (eyes != none && std::abs(eyes) > depthOfEyes)
    return "the foremost points at the pupils lie " + roundedText(std::abs(eyes)) + " pupil units " +
           (eyes > 0.0 ? "in front of" : "behind") +
           " them: the face looks backwards, or the pupils lack their depth; turn it to look along +z, and give the "
           "pupils as x,y,z,x,y,z";
  if (nose != none && forehead != none && forehead > nose + foreheadAhead)
    return "the face stands on its head or is mirrored by its pupils (what is above them reaches further forward than "
           "the nose below); exchange the pupils (left is the subject's own), or turn the face upright and to +z";
  return {};
}

}  // namespace mien
