#pragma once

#include <string>

#include "FaceCurves.h"
#include "FaceLandmarks.h"

namespace mien {

/// How a face is fitted to a frontal picture.
struct PictureSettings {
  enum class Vertical { Recognised, Down, Up };

  Vertical y = Vertical::Recognised;  ///< which way y grows in the picture
  double millimetres = 0.0;           ///< of one pixel; 0: the face gets the size of the known one
  bool symmetric = false;             ///< whether both sides of the face are averaged
  bool upright = true;                ///< whether a head tilted in the picture is set upright
};

/// What the fit found in the picture, and how well it came out.
struct PictureReport {
  bool yDown = false;
  double millimetres = 1.0;  ///< of one pixel
  double tilt = 0.0;         ///< radians that the head leans in the picture, positive to the picture's left
  double misfit =
      0.0;  ///< RMS distance of the landmarks from those of the known face before the warp, in eye distances
  double residual = 0.0;    ///< RMS distance of the fitted landmarks from the picture's, mm
  FaceLandmarks landmarks;  ///< of the picture in the frame of the face, with the depths of the fitted face
};

/// Fits a known face to the 68 landmarks of a frontal picture: x and y of all curves follow the smooth warp that takes
/// the known landmarks to the picture's [Bookstein 1989], beyond the face the nearest affine map; depth is the known
/// face's in the picture's size.
/// @param picture  x and y in pixels or any unit; z is not used
/// @return nothing, or one sentence that says why this is no frontal face and what to do; `face` is then left alone
std::string fitToPicture(const FaceCurves& known, const FaceLandmarks& knownLandmarks, const FaceLandmarks& picture,
                         const PictureSettings& settings, FaceCurves& face, PictureReport& report);

}  // namespace mien
