#include "EyePupils.h"

#include <Eigen/Geometry>
#include <map>

#include "JoinedSets.h"

namespace mien {

namespace {

/// A connected part of the mesh.
struct ConnectedPart {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::AlignedBox3d box;
  int count = 0;

  Eigen::Vector3d middle() const { return sum / count; }
};

/// Named by one of their vertices.
using Parts = std::map<int, ConnectedPart>;

const ConnectedPart* eyeball(const Parts& parts, const Eigen::Vector3d& eye, double width) {
  const ConnectedPart* best = nullptr;
  for (const auto& [name, part] : parts)
    if ((part.middle() - eye).norm() < width && (!best || part.count > best->count)) best = &part;
  return best;
}

Parts partsOf(const MeshVertices& vertices, JoinedSets& sets) {
  Parts parts;
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
    ConnectedPart& part = parts[sets.find(static_cast<int>(i))];
    part.sum += vertices.row(i).transpose();
    part.box.extend(vertices.row(i).transpose());
    ++part.count;
  }
  return parts;
}

}  // namespace

EyePupils eyePupils(const MeshVertices& vertices, const MeshEdges& edges, const LandmarkVertices& landmarks,
                    std::vector<bool>* inEyes) {
  JoinedSets sets(static_cast<std::size_t>(vertices.rows()));
  for (const auto& edge : edges) sets.join(edge[0], edge[1]);
  Parts parts = partsOf(vertices, sets);
  for (const int landmark : landmarks) parts.erase(sets.find(landmark));
  const auto middleOf = [&](int first) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int i = first; i < first + 6; ++i) middle += vertices.row(landmarks[i]).transpose() / 6.0;
    return middle;
  };
  const auto ballOf = [&](int first) {
    return eyeball(parts, middleOf(first),
                   (vertices.row(landmarks[first]) - vertices.row(landmarks[first + 3])).norm());
  };
  const ConnectedPart *left = ballOf(42), *right = ballOf(36);
  if (inEyes) {
    inEyes->assign(static_cast<std::size_t>(vertices.rows()), false);
    for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
      const auto part = parts.find(sets.find(static_cast<int>(i)));
      for (const ConnectedPart* ball : {left, right})
        if (ball && part != parts.end() && ball->box.contains(part->second.box)) (*inEyes)[i] = true;
    }
  }
  return {left ? left->middle() : middleOf(42), right ? right->middle() : middleOf(36)};
}

}  // namespace mien
