#pragma once

#include <functional>
#include <vector>

#include "MeshDistance.h"
#include "MienSurfaceModule.h"

class vtkPolyData;

namespace mien {

/// How far the points of a surface lie from another, weighted with the area that belongs to each point.
struct DistanceSummary {
  double rms = 0.0;           ///< mm
  double mean = 0.0;          ///< of the absolute distances, mm
  double median = 0.0;        ///< half of the area lies no further away, mm
  double percentile95 = 0.0;  ///< 95 % of the area lie no further away, mm
  double maximum = 0.0;       ///< mm
  double area = 0.0;          ///< of all points that were measured, mm2
  long long points = 0;
};

/// Distances of points to a fixed triangulated surface. Safe to call from several threads.
class MIENSURFACE_EXPORT SurfaceDistance {
 public:
  /// @param triangles  see trianglesOf()
  explicit SurfaceDistance(vtkPolyData* triangles);

  /// The distance to the nearest point (mm). Signed: negative behind the surface.
  /// @param nearest  if not nullptr, that point
  double operator()(const double point[3], bool withSign, double nearest[3] = nullptr) const;

  MeshDistance::Nearest nearest(const double point[3]) const {
    return mesh_.nearest(Eigen::Map<const Eigen::Vector3d>(point));
  }

 private:
  MeshDistance mesh_;
};

/// Sums up; only points for which `counts` says so are taken.
DistanceSummary summarize(const std::vector<double>& distances, const std::vector<double>& areas,
                          const std::function<bool(size_t)>& counts);

}  // namespace mien
