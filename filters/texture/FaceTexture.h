#pragma once

#include <string>

#include "FaceState.h"
#include "FaceWarpLayout.h"
#include "MienTextureModule.h"
#include "Progress.h"

class vtkImageData;
class vtkPolyData;

namespace mien {

constexpr int faceTextureWidth = 2048, faceTextureHeight = 1024;  ///< pixels, unless something else is asked for

/// The warp mesh that lies beside a photograph: its name with .csv for its ending.
MIENTEXTURE_EXPORT std::string meshBeside(const std::string& imageFile);

/// The texture of a face: the photograph and the source mesh of the state, warped onto the (u, v) of the face with
/// these neutral boundary curves [S 4.2], faceTextureWidth x faceTextureHeight pixels. The photograph spans the frontal
/// half of v; around the back its edge colours go over into each other.
/// @param texture  unsigned char, 3 or 4 components; for a surface with `TextureCoordinates`
/// @return nothing, or one sentence that says which file is at fault and why
MIENTEXTURE_EXPORT std::string makeFaceTexture(const FaceState& state, vtkPolyData* curves, vtkImageData* texture);

/// The same from a photograph and a source mesh that are at hand, `width` x `height` pixels.
/// @return nothing, or one sentence that says what is wrong with the mesh, or that the work was stopped
MIENTEXTURE_EXPORT std::string warpFaceTexture(vtkImageData* photograph, const WarpMesh& source, vtkPolyData* curves,
                                               int width, int height, const Progress& progress, vtkImageData* texture);

/// The mesh of a file, or of a text (InlineText.h), if it is one that has places on the face.
/// @return nothing, or `FILE:LINE: what is wrong and what to do`; of a text `mesh:LINE: ...`
MIENTEXTURE_EXPORT std::string readSourceMesh(const std::string& fileOrText, WarpMesh& mesh);

/// A mesh for a photograph of `width` x `height` pixels from a list of its landmarks, see ImageLandmarks.h.
/// @return nothing, or `FILE:LINE: what is wrong and what to do`
MIENTEXTURE_EXPORT std::string readLandmarkMesh(const std::string& file, FaceWarpLayout::Kind kind, vtkPolyData* curves,
                                                double width, double height, WarpMesh& mesh);

/// A mesh of 7 x 7 points for a photograph of which nothing is known, see startingMesh().
/// @return nothing, or one sentence that says what the curves lack
MIENTEXTURE_EXPORT std::string makeStartingMesh(vtkPolyData* curves, double width, double height, WarpMesh& mesh);

/// An image as renderers and screens take it: unsigned char, 3 or 4 components, at most `largestSide` pixels along a
/// side, each the mean of what it covers.
/// @return nothing, or one sentence that says what is wrong, or that the work was stopped
MIENTEXTURE_EXPORT std::string reduceImage(vtkImageData* image, int largestSide, const Progress& progress,
                                           vtkImageData* reduced);

}  // namespace mien
