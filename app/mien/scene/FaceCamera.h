#pragma once

#include "ViewDirection.h"

class vtkCamera;
class vtkPolyData;

namespace mien {

/// The part of the picture that the face fills, in a picture of that shape.
struct FaceFrame {
  double aspect = 1.0;     ///< width / height of the picture
  double freeShare = 1.0;  ///< of the width, from the left; the rest is kept for a colour bar
};

/// Places the camera so that the surface, as seen in perspective, fills the frame but for a margin.
void placeFaceCamera(vtkPolyData* surface, const ViewDirection& view, const FaceFrame& frame, vtkCamera* camera);

/// Whether a camera placed so sees the whole surface.
bool isWithinFrame(vtkPolyData* surface, const ViewDirection& view, const FaceFrame& frame, vtkCamera* camera);

}  // namespace mien
