#pragma once

#include <vector>

#include "PointTree.h"
#include "TriangleMesh.h"

namespace mien {

/// What a point of a face met on the skin of a scan: the nearest point that looks the same way.
struct SkinMatch {
  int skin = -1;        ///< vertex of the scan; -1: none within reach
  double gap = 0.0;     ///< mm along its normal, from the face to its tangent plane
  double weight = 0.0;  ///< less for skin that looks another way or lies far off
};

/// The skin of a scan, asked while a face is bent onto it.
class SkinMatches {
 public:
  using Points = TriangleMesh::Vertices;

  explicit SkinMatches(const TriangleMesh& scan);

  /// For each vertex of `face`, skin within `reach` (mm).
  std::vector<SkinMatch> of(const TriangleMesh& face, double reach) const;

  const Points& points() const { return points_; }
  const Points& normals() const { return normals_; }  ///< outwards

 private:
  Points points_, normals_;
  PointTree tree_;
};

}  // namespace mien
