#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "FAPFrame.h"
#include "FAPUnit.h"

namespace mien {

/// Where a feature point goes for a positive value; left and right are the subject's own.
enum class FAPDirection { None, Left, Right, Up, Down, Forward, Growing, ConcaveUpward };

/// What the standard says about one facial animation parameter (ISO/IEC 14496-2, Annex C).
struct FAPDefinition {
  int number;             ///< 1 .. 68
  std::string_view name;  ///< for people; parameters are matched by number, as names differ between tools
  FAPUnit unit;
  FAPDirection positiveMotion;  ///< for angles the way the front of the head or eyeball turns
  bool bidirectional;           ///< whether negative values have a meaning
  int group;  ///< 1 visemes and expressions, 2 jaw and inner lips, 3 eyes, 4 brows, 5 cheeks, 6 tongue,
              ///< 7 head, 8 outer lips, 9 nose, 10 ears
  std::string_view featurePoint;  ///< the (first) point it moves; "" for FAP 1 and 2
  int mirrorPartner;              ///< the same motion on the other side; itself on the midline
  int mirrorSign;                 ///< -1 where the mirrored motion has the other sign (turning left becomes right)
  bool inPaperSubset;             ///< one of the 22 of Sheng et al. 2011, section 5
  bool hasSurface;                ///< false for the eyeballs, the tongue and the ears, which the PDE face does not have
};

/// All 68, in order: fapTable[n - 1] is FAP n.
inline constexpr std::array<FAPDefinition, FAPFrame::count> fapTable = {{
    // clang-format off
    {1, "viseme", FAPUnit::None, FAPDirection::None, false, 1, "", 1, 1, false, true},
    {2, "expression", FAPUnit::None, FAPDirection::None, false, 1, "", 2, 1, false, true},
    {3, "open_jaw", FAPUnit::MouthNoseSeparation, FAPDirection::Down, false, 2, "2.1", 3, 1, false, true},
    {4, "lower_t_midlip", FAPUnit::MouthNoseSeparation, FAPDirection::Down, true, 2, "2.2", 4, 1, false, true},
    {5, "raise_b_midlip", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 2, "2.3", 5, 1, false, true},
    {6, "stretch_l_cornerlip", FAPUnit::MouthWidth, FAPDirection::Left, true, 2, "2.4", 7, 1, false, true},
    {7, "stretch_r_cornerlip", FAPUnit::MouthWidth, FAPDirection::Right, true, 2, "2.5", 6, 1, false, true},
    {8, "lower_t_lip_lm", FAPUnit::MouthNoseSeparation, FAPDirection::Down, true, 2, "2.6", 9, 1, false, true},
    {9, "lower_t_lip_rm", FAPUnit::MouthNoseSeparation, FAPDirection::Down, true, 2, "2.7", 8, 1, false, true},
    {10, "raise_b_lip_lm", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 2, "2.8", 11, 1, false, true},
    {11, "raise_b_lip_rm", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 2, "2.9", 10, 1, false, true},
    {12, "raise_l_cornerlip", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 2, "2.4", 13, 1, false, true},
    {13, "raise_r_cornerlip", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 2, "2.5", 12, 1, false, true},
    {14, "thrust_jaw", FAPUnit::MouthNoseSeparation, FAPDirection::Forward, false, 2, "2.1", 14, 1, false, true},
    {15, "shift_jaw", FAPUnit::MouthWidth, FAPDirection::Right, true, 2, "2.1", 15, -1, false, true},
    {16, "push_b_lip", FAPUnit::MouthNoseSeparation, FAPDirection::Forward, true, 2, "2.3", 16, 1, false, true},
    {17, "push_t_lip", FAPUnit::MouthNoseSeparation, FAPDirection::Forward, true, 2, "2.2", 17, 1, false, true},
    {18, "depress_chin", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 2, "2.10", 18, 1, false, true},
    {19, "close_t_l_eyelid", FAPUnit::IrisDiameter, FAPDirection::Down, true, 3, "3.1", 20, 1, true, true},
    {20, "close_t_r_eyelid", FAPUnit::IrisDiameter, FAPDirection::Down, true, 3, "3.2", 19, 1, true, true},
    {21, "close_b_l_eyelid", FAPUnit::IrisDiameter, FAPDirection::Up, true, 3, "3.3", 22, 1, false, true},
    {22, "close_b_r_eyelid", FAPUnit::IrisDiameter, FAPDirection::Up, true, 3, "3.4", 21, 1, false, true},
    {23, "yaw_l_eyeball", FAPUnit::Angle, FAPDirection::Left, true, 3, "3.5", 24, -1, false, false},
    {24, "yaw_r_eyeball", FAPUnit::Angle, FAPDirection::Left, true, 3, "3.6", 23, -1, false, false},
    {25, "pitch_l_eyeball", FAPUnit::Angle, FAPDirection::Down, true, 3, "3.5", 26, 1, false, false},
    {26, "pitch_r_eyeball", FAPUnit::Angle, FAPDirection::Down, true, 3, "3.6", 25, 1, false, false},
    {27, "thrust_l_eyeball", FAPUnit::EyeSeparation, FAPDirection::Forward, true, 3, "3.5", 28, 1, false, false},
    {28, "thrust_r_eyeball", FAPUnit::EyeSeparation, FAPDirection::Forward, true, 3, "3.6", 27, 1, false, false},
    {29, "dilate_l_pupil", FAPUnit::IrisDiameter, FAPDirection::Growing, true, 3, "3.5", 30, 1, false, false},
    {30, "dilate_r_pupil", FAPUnit::IrisDiameter, FAPDirection::Growing, true, 3, "3.6", 29, 1, false, false},
    {31, "raise_l_i_eyebrow", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 4, "4.1", 32, 1, true, true},
    {32, "raise_r_i_eyebrow", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 4, "4.2", 31, 1, true, true},
    {33, "raise_l_m_eyebrow", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 4, "4.3", 34, 1, true, true},
    {34, "raise_r_m_eyebrow", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 4, "4.4", 33, 1, true, true},
    {35, "raise_l_o_eyebrow", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 4, "4.5", 36, 1, true, true},
    {36, "raise_r_o_eyebrow", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 4, "4.6", 35, 1, true, true},
    {37, "squeeze_l_eyebrow", FAPUnit::EyeSeparation, FAPDirection::Right, true, 4, "4.1", 38, 1, false, true},
    {38, "squeeze_r_eyebrow", FAPUnit::EyeSeparation, FAPDirection::Left, true, 4, "4.2", 37, 1, false, true},
    {39, "puff_l_cheek", FAPUnit::EyeSeparation, FAPDirection::Left, true, 5, "5.1", 40, 1, true, true},
    {40, "puff_r_cheek", FAPUnit::EyeSeparation, FAPDirection::Right, true, 5, "5.2", 39, 1, true, true},
    {41, "lift_l_cheek", FAPUnit::EyeNoseSeparation, FAPDirection::Up, false, 5, "5.3", 42, 1, true, true},
    {42, "lift_r_cheek", FAPUnit::EyeNoseSeparation, FAPDirection::Up, false, 5, "5.4", 41, 1, true, true},
    {43, "shift_tongue_tip", FAPUnit::MouthWidth, FAPDirection::Right, true, 6, "6.1", 43, -1, false, false},
    {44, "raise_tongue_tip", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 6, "6.1", 44, 1, false, false},
    {45, "thrust_tongue_tip", FAPUnit::MouthWidth, FAPDirection::Forward, true, 6, "6.1", 45, 1, false, false},
    {46, "raise_tongue", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 6, "6.2", 46, 1, false, false},
    {47, "tongue_roll", FAPUnit::Angle, FAPDirection::ConcaveUpward, false, 6, "6.3", 47, 1, false, false},
    {48, "head_pitch", FAPUnit::Angle, FAPDirection::Down, true, 7, "7.1", 48, 1, false, true},
    {49, "head_yaw", FAPUnit::Angle, FAPDirection::Left, true, 7, "7.1", 49, -1, false, true},
    {50, "head_roll", FAPUnit::Angle, FAPDirection::Right, true, 7, "7.1", 50, -1, false, true},
    {51, "lower_t_midlip_o", FAPUnit::MouthNoseSeparation, FAPDirection::Down, true, 8, "8.1", 51, 1, true, true},
    {52, "raise_b_midlip_o", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 8, "8.2", 52, 1, true, true},
    {53, "stretch_l_cornerlip_o", FAPUnit::MouthWidth, FAPDirection::Left, true, 8, "8.3", 54, 1, true, true},
    {54, "stretch_r_cornerlip_o", FAPUnit::MouthWidth, FAPDirection::Right, true, 8, "8.4", 53, 1, true, true},
    {55, "lower_t_lip_lm_o", FAPUnit::MouthNoseSeparation, FAPDirection::Down, true, 8, "8.5", 56, 1, false, true},
    {56, "lower_t_lip_rm_o", FAPUnit::MouthNoseSeparation, FAPDirection::Down, true, 8, "8.6", 55, 1, false, true},
    {57, "raise_b_lip_lm_o", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 8, "8.7", 58, 1, false, true},
    {58, "raise_b_lip_rm_o", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 8, "8.8", 57, 1, false, true},
    {59, "raise_l_cornerlip_o", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 8, "8.3", 60, 1, true, true},
    {60, "raise_r_cornerlip_o", FAPUnit::MouthNoseSeparation, FAPDirection::Up, true, 8, "8.4", 59, 1, true, true},
    {61, "stretch_l_nose", FAPUnit::EyeNoseSeparation, FAPDirection::Left, true, 9, "9.1", 62, 1, true, true},
    {62, "stretch_r_nose", FAPUnit::EyeNoseSeparation, FAPDirection::Right, true, 9, "9.2", 61, 1, true, true},
    {63, "raise_nose", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 9, "9.3", 63, 1, true, true},
    {64, "bend_nose", FAPUnit::EyeNoseSeparation, FAPDirection::Right, true, 9, "9.3", 64, -1, true, true},
    {65, "raise_l_ear", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 10, "10.1", 66, 1, false, false},
    {66, "raise_r_ear", FAPUnit::EyeNoseSeparation, FAPDirection::Up, true, 10, "10.2", 65, 1, false, false},
    {67, "pull_l_ear", FAPUnit::EyeNoseSeparation, FAPDirection::Left, true, 10, "10.3", 68, 1, false, false},
    {68, "pull_r_ear", FAPUnit::EyeNoseSeparation, FAPDirection::Right, true, 10, "10.4", 67, 1, false, false},
    // clang-format on
}};

/// @param number 1 .. 68
constexpr const FAPDefinition& fapDefinition(int number) {
  return fapTable[number - 1];
}

/// The 22 FAPs of Sheng et al. 2011, ascending.
std::vector<int> paperSubset();

/// Which of these FAPs the face has no surface for, in the order given; numbers outside 1 .. 68 are left out.
std::vector<int> fapsWithoutSurface(const std::vector<int>& faps);

/// The frame that shows the mirrored face: partners exchange their values, with the sign of the motion.
/// Visemes and expressions are symmetric and stay.
FAPFrame mirrored(const FAPFrame& frame);

}  // namespace mien
