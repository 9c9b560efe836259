#pragma once

#include "FaceSides.h"

namespace mien {

/// The pupils of a head, in the mesh's own unit.
struct EyePupils {
  Eigen::Vector3d left = Eigen::Vector3d::Zero();  ///< the subject's
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
};

/// From the 68 landmarks as vertices of a mesh: the mean of the eyeball's vertices, an eyeball being the largest part
/// of the mesh apart from the skin whose middle lies within an eye's width of the middle of landmarks 36-41 (42-47);
/// that middle itself on a mesh without eyeballs. All indices valid.
/// @param inEyes  told for each vertex whether it belongs to an eye and not to the skin: the eyeball, and all parts of
///     the mesh that lie wholly within the eyeball's box
EyePupils eyePupils(const MeshVertices& vertices, const MeshEdges& edges, const LandmarkVertices& landmarks,
                    std::vector<bool>* inEyes = nullptr);

}  // namespace mien
