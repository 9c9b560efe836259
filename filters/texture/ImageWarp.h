#pragma once

#include "MeshWarp.h"

class vtkAlgorithm;
class vtkImageData;

namespace mien {

/// Fills the extent of `output` with scalars warped from one slice of `image`, in threads, with the progress of
/// `algorithm`.
/// @return false when the algorithm was aborted; the output is then not to be used
bool warpImage(const MeshWarp& warp, vtkImageData* image, bool closed, vtkAlgorithm* algorithm, vtkImageData* output);

}  // namespace mien
