#pragma once

#include <string>
#include <vector>

#include "FAPSequence.h"
#include "FacialActionMap.h"

namespace mien {

/// How a table of facial capture is written; CaptureParser.h reads all of them.
enum class CaptureStyle {
  FACS,          ///< frame, time, AU1L, AU1R, .., AU64, within 0 .. 1
  OpenFace,      ///< frame, timestamp, confidence, success, pose_Rx .., AU01_r, .., within 0 .. 5, and AU28_c
  LiveLinkFace,  ///< Timecode (60 frames per second), BlendshapeCount, EyeBlinkLeft, .., RightEyeRoll: 61 values
};

/// What a table of facial capture cannot say of an animation.
struct CaptureLoss {
  std::vector<int> faps;    ///< FAPs that the animation sets and no column moves
  double share = 0.0;       ///< of the movement of those that are left, root mean square over all frames
  double worstFrame = 0.0;  ///< the number of the frame that loses most
};

/// Writes the actions that come nearest to the FAPs (ActionFit.h). Visemes and expressions must have been turned into
/// low-level FAPs before; those that are left are counted as lost.
/// @return nothing, or one sentence that says why it cannot be written; the text is then as it was
std::string writeCapture(const FAPSequence& sequence, CaptureStyle style, const FacialActionMap& map, std::string& text,
                         CaptureLoss& loss);

}  // namespace mien
