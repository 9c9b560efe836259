#include "SurfaceParameters.h"

#include <vtkPDEFaceAlgorithm.h>

#include <algorithm>
#include <sstream>

namespace mien {

void setParameters(const FaceSurfaceOptions& options, vtkPDEFaceAlgorithm* filter) {
  filter->SetScheme(options.scheme);
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) filter->SetSmoothing(patch, options.smoothing[patch]);
  filter->SetNumberOfModes(options.modes);
  filter->SetRemainder(options.remainder);
  filter->SetDerivativeStrength(options.derivativeStrength);
}

std::string parameterText(const FaceSurfaceOptions& options) {
  std::ostringstream text;
  text << "scheme " << options.scheme << ", a = " << options.smoothing.front();
  const bool uniform = std::all_of(options.smoothing.begin(), options.smoothing.end(),
                                   [&](double a) { return a == options.smoothing.front(); });
  for (int patch = 1; patch < FaceLayout::patchCount && !uniform; ++patch) text << ", " << options.smoothing[patch];
  text << ", N = " << options.modes << (options.remainder ? ", with" : ", without") << " remainder";
  return text.str();
}

}  // namespace mien
