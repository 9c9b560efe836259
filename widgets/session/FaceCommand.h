#pragma once

#include <QString>

namespace mien {

class FaceModel;
class FaceView;

/// The command that draws what the face view shows: `mien render` with the options of the face, its style and view.
QString renderCommand(const FaceModel& model, const FaceView& view);

}  // namespace mien
