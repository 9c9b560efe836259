#include "SurfaceParameters.h"

#include <vtkPDEFaceAlgorithm.h>

namespace mien {

void setParameters(const FaceSurfaceOptions& options, vtkPDEFaceAlgorithm* filter) {
  filter->SetScheme(options.scheme);
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) filter->SetSmoothing(patch, options.smoothing[patch]);
  filter->SetNumberOfModes(options.modes);
  filter->SetRemainder(options.remainder);
  filter->SetDerivativeStrength(options.derivativeStrength);
}

}  // namespace mien
