#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "FacialActionMap.h"

namespace mien {

/// What the columns of a table of facial capture mean: action units or blendshapes, rotations of the head, time.
struct CaptureColumns {
  /// A column that moves the face.
  struct Effect {
    std::size_t column = 0;
    std::vector<std::pair<int, double>> faps;  ///< at a value of 1
    double full = 1.0;      ///< the value of full strength; 0 when the table must tell: 1, or what more it reaches
    bool isAngle = false;   ///< any sign and size
    bool standsIn = false;  ///< counts only when no other column moves its FAP in the whole table
  };

  std::vector<Effect> effects;
  std::optional<std::size_t> frame, time, timeCode, success, face, shapeCount;
  std::vector<std::string> unused;  ///< names of other columns
  std::size_t actions = 0;          ///< how many columns are action units or blendshapes
  std::string fault;                ///< names two columns that mean the same; else empty

  /// "AU1", "AU01_r", .. as ActionUnitName.h reads them; "pose_Rx", .. Presences ("_c") only count where there is no
  /// intensity.
  static CaptureColumns ofActionUnits(const std::vector<std::string_view>& header, const FacialActionMap& map);

  /// "EyeBlinkLeft", "eyeBlinkLeft", "eyeBlink_L", ..; "HeadYaw", ..
  static CaptureColumns ofBlendshapes(const std::vector<std::string_view>& header, const FacialActionMap& map);
};

}  // namespace mien
