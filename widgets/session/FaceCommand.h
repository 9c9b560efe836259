#pragma once

#include <QString>
#include <string>

namespace mien {

class FaceModel;
class FaceView;

/// What is seen beside the face itself.
struct FaceLook {
  std::string array;       ///< of the surface, that colours it; empty: none
  bool hasCurves = false;  ///< the boundary curves as lines on it
};

/// The command that draws what the face view shows: `mien render` with the options of the face, its style, look and
/// view.
QString renderCommand(const FaceModel& model, const FaceView& view, const FaceLook& look = {});

}  // namespace mien
