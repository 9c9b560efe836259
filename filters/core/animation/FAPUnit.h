#pragma once

#include <string_view>

namespace mien {

/// The unit that one FAP value counts in (ISO/IEC 14496-2): a distance of the neutral face divided by 1024, or an
/// angle.
enum class FAPUnit {
  None,                 ///< FAP 1 and 2, which select visemes and expressions
  IrisDiameter,         ///< IRISD: 3.1.y - 3.3.y, the gap between the lids
  EyeSeparation,        ///< ES: 3.5.x - 3.6.x, from pupil to pupil
  EyeNoseSeparation,    ///< ENS: 3.5.y - 9.15.y
  MouthNoseSeparation,  ///< MNS: 9.15.y - 2.2.y
  MouthWidth,           ///< MW: 8.3.x - 8.4.x
  Angle                 ///< AU: 1e-5 rad, not divided by 1024
};

constexpr double distanceUnitDivisor = 1024.0;  ///< a FAP value of 1024 moves by the whole distance
constexpr double radiansPerAngleUnit = 1e-5;

/// The symbol of the standard: "IRISD", "ES", "ENS", "MNS", "MW", "AU", or "" for None.
constexpr std::string_view symbol(FAPUnit unit) {
  switch (unit) {
    case FAPUnit::None:
      return "";
    case FAPUnit::IrisDiameter:
      return "IRISD";
    case FAPUnit::EyeSeparation:
      return "ES";
    case FAPUnit::EyeNoseSeparation:
      return "ENS";
    case FAPUnit::MouthNoseSeparation:
      return "MNS";
    case FAPUnit::MouthWidth:
      return "MW";
    case FAPUnit::Angle:
      return "AU";
  }
  return "";
}

}  // namespace mien
