#pragma once

#include "FigureDrawing.h"
#include "ImageLandmarks.h"
#include "WarpMesh.h"

class vtkImageData;

namespace mien {

/// A photograph with its landmarks and their names: where each of the 25 points, or of the 68, belongs. Needs a
/// FigureApplication.
FigureDrawing drawLandmarks(vtkImageData* photograph, const ImageLandmarks& landmarks);

/// The named points of a mesh over an image.
ImageLandmarks namedPoints(const WarpMesh& mesh);

}  // namespace mien
