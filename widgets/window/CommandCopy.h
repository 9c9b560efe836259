#pragma once

namespace mien {

class FaceModel;
class ViewArea;

/// Copies the `mien render` command of the face as it is shown, and says so, and what of the window it leaves out.
void copyCommand(FaceModel* model, const ViewArea& views);

}  // namespace mien
