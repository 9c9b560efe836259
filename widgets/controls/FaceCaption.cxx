#include "FaceCaption.h"

#include "FaceModel.h"
#include "FaceNote.h"

namespace mien {

void describeFace(const FaceModel& model, const std::vector<std::string>& schemes, bool hasOneSmoothing,
                  Figure& figure) {
  FaceState state = model.lastingState();
  state.deformation = {};
  const std::string frame = model.frameText(), motion = motionText(state, frame);
  figure.title += ": " + (motion.empty() ? std::string("neutral face") : motion);
  figure.note = faceNote(state, schemes, hasOneSmoothing, frame) + (figure.note.empty() ? "" : "; " + figure.note);
}

}  // namespace mien
