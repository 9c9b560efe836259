#pragma once

#include <string>
#include <utility>
#include <vector>

#include "FaceCurves.h"
#include "ImageLandmarks.h"
#include "LandmarkPlaces.h"
#include "WarpMesh.h"

namespace mien {

/// Which places of the face are the points of a warp mesh: rows x columns addresses (curve, v) on the boundary curves
/// [S 4.2].
///
/// The 7 x 7 mesh has 25 facial feature points within and 24 points around them on C1, C28 and v = pi -+ pi / 2, where
/// the photograph ends and the sides of the head begin. The 25, by their MPEG-4 names, from the subject's right to the
/// left:
///
///     | row | places | on curves |
///     | brows     | 4.6, 4.4, brow_middle, 4.3, 4.5                                | C6                  |
///     | upper lids| 3.12, 3.2, nose_bridge, 3.1, 3.7                               | C9, corners between C9 and C10 |
///     | cheeks    | 5.4, 3.4, 9.12, 3.3, 5.3                                       | C13 C10 C12 C10 C13 |
///     | upper lip | 8.4, 8.6, 8.1, 8.5, 8.3                                        | C22 C21 C21 C21 C22 |
///     | lower lip | lower_lip_right, 8.8, 8.2, 8.7, lower_lip_left                 | C23                 |
///
/// brow_middle and nose_bridge lie on the midline, lower_lip_right halfway in v between 8.8 and 8.4. The fine mesh
/// takes 19 curves at 21 places each, every 9 degrees of v: with it lids and lips, which 25 points cannot follow, lie
/// where they are on the photograph.
struct FaceWarpLayout {
  enum class Kind { SevenBySeven, Fine };

  int rows = 0, columns = 0;
  std::vector<FacePlace> places;  ///< row after row, from C1 down and with v growing: left to right in the picture

  /// The places on this face. @return nothing, or one sentence that says which feature point the face lacks
  std::string set(Kind kind, const FaceCurves& face);

  /// Rows and columns of a layout.
  static std::pair<int, int> sizeOf(Kind kind);

  /// Which layout a mesh of that size has. @return false for a size that neither has
  static bool kindOf(const WarpMesh& mesh, Kind& kind);
};

/// Where the places lie in a texture that the surface is covered with, at (v / 2 pi, u) of its width and height [S
/// Figure 3 c, d].
WarpMesh textureMesh(const FaceWarpLayout& layout, double width, double height);

/// Where the places lie on a picture of this very face, seen from the front without perspective.
/// @param corner  x and y in mm that the picture's upper left corner shows
WarpMesh frontMesh(const FaceWarpLayout& layout, const FaceCurves& face, double pixelsPerMillimetre,
                   const Eigen::Vector2d& corner, double width, double height);

/// Where the places may lie on a photograph of which nothing is known: this face seen from the front, in the middle,
/// over four fifths of the picture's width or height. A mesh to be moved by hand.
WarpMesh startingMesh(const FaceWarpLayout& layout, const FaceCurves& face, double width, double height);

/// Where the places lie on a photograph with these landmarks: the face seen from the front, bent so that its feature
/// points meet them (SmoothWarp). Landmarks are the 68 by number, or the 25 places by name; with these the sides of the
/// face lie where the features put them (AffineFit), drawn in by 7 % below the brows.
/// @return nothing, or one sentence that says which landmark is missing, lies beyond the picture, or (of the 25) more
/// than 12 mm from where the others put it, or that the mesh would be folded
std::string photographMesh(const FaceWarpLayout& layout, const FaceCurves& face, const ImageLandmarks& landmarks,
                           double width, double height, WarpMesh& mesh);

}  // namespace mien
