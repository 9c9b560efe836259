#include "PupilMarkers.h"

#include <algorithm>

namespace mien {

bool liesOnPupil(const PupilNormalisation& pupils, const Eigen::Vector3d& point) {
  constexpr double reach = 0.02;
  const Eigen::Vector2d place = pupils.apply(point).head<2>();
  return std::min((place - Eigen::Vector2d(1.0, 0.0)).norm(), (place + Eigen::Vector2d(1.0, 0.0)).norm()) < reach;
}

std::vector<std::string> takeOutPupils(MarkerTable& table) {
  std::vector<std::string> names;
  const auto isPupil = [&](const Marker& marker) {
    const bool found = liesOnPupil(table.neutral, marker.neutral);
    if (found) names.push_back(marker.name);
    return found;
  };
  table.markers.erase(std::remove_if(table.markers.begin(), table.markers.end(), isPupil), table.markers.end());
  return names;
}

}  // namespace mien
