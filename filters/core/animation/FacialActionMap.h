#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien {

/// An action unit, a blendshape or a rotation of the head, as FAP values at full strength (at 1 rad for rotations).
struct CaptureAction {
  std::string name;                          ///< "AU12", "mouthSmileLeft", "HeadYaw"
  std::string description;                   ///< for people
  std::vector<std::pair<int, double>> faps;  ///< FAP number and value, ascending
  std::vector<int> weak;     ///< those of the FAPs that sources contradict each other in, or only one knows
  bool sided = false;        ///< is written with a column for each side
  bool writtenOnly = false;  ///< repeats what other columns say, and is not read
  bool standsIn = false;     ///< repeats what other columns say, and is read when those are missing or always 0
};

/// One side of an action unit: the FAPs of that side, and half of those on the midline, so that both sides are the
/// whole.
CaptureAction sideOf(const CaptureAction& action, bool left);

/// What facial capture moves, read from JSON: {"format": "mien facial action map", "version": 1, "action_units": [...],
/// "blendshapes": [...], "rotations": [...]}, each entry {"name", "faps": {"FAP": value}, ...}; see data/README.md.
struct FacialActionMap {
  static constexpr int version = 1;

  std::vector<CaptureAction> actionUnits;  ///< of FACS, by ascending number
  std::vector<CaptureAction> blendshapes;  ///< of ARKit, in the order of Live Link Face
  std::vector<CaptureAction> rotations;    ///< "HeadYaw" .., "LeftEyeYaw" .., "pose_Rx" ..
  int faultLine = 0;                       ///< of the last text, where it is no JSON; 0 for any other fault

  /// Replaces the map; on a fault it stays as it was.
  /// @return nothing, or one sentence that names the entry and what is wrong with it
  std::string parse(const std::string& json);
};

/// The action of that name in any case, without regard to "_", "-" and blanks, "L" and "R" after a "_" standing for
/// Left and Right; or nullptr.
const CaptureAction* findAction(const std::vector<CaptureAction>& actions, std::string_view name);

}  // namespace mien
