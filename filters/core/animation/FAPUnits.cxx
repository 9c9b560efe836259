#include "FAPUnits.h"

#include <array>
#include <utility>

namespace mien {

namespace {

/// Looks up feature points and remembers the first one that is missing.
class FeatureFinder {
 public:
  explicit FeatureFinder(const FaceCurves& face) : face_(face) {}

  Eigen::Vector3d at(const char* id) {
    if (const FeaturePoint* point = face_.feature(id)) return face_.curves.at(point->curve, point->v);
    if (missing_.empty()) missing_ = id;
    return Eigen::Vector3d::Zero();
  }

  const std::string& missing() const { return missing_; }

 private:
  const FaceCurves& face_;
  std::string missing_;
};

std::string describeUnitFault(const FAPUnits& units) {
  for (FAPUnit unit : {FAPUnit::IrisDiameter, FAPUnit::EyeSeparation, FAPUnit::EyeNoseSeparation,
                       FAPUnit::MouthNoseSeparation, FAPUnit::MouthWidth})
    if (!(units.distance(unit) > 0.0))
      return "the FAP unit " + std::string(symbol(unit)) + " measures " + std::to_string(units.distance(unit)) +
             " mm on this face and must be positive; check its feature points";
  return {};
}

}  // namespace

double FAPUnits::distance(FAPUnit unit) const {
  switch (unit) {
    case FAPUnit::IrisDiameter:
      return irisDiameter;
    case FAPUnit::EyeSeparation:
      return eyeSeparation;
    case FAPUnit::EyeNoseSeparation:
      return eyeNoseSeparation;
    case FAPUnit::MouthNoseSeparation:
      return mouthNoseSeparation;
    case FAPUnit::MouthWidth:
      return mouthWidth;
    default:
      return 0.0;
  }
}

double FAPUnits::perValue(FAPUnit unit) const {
  return unit == FAPUnit::Angle ? radiansPerAngleUnit : distance(unit) / distanceUnitDivisor;
}

std::string measureFAPUnits(const FaceCurves& face, FAPUnits& units) {
  if (!face.hasPupils) return "the face has no pupils, which the FAP units ES and ENS need; add the array Pupils";
  FeatureFinder find(face);
  const double noseBase = find.at("9.15").y();
  FAPUnits measured;
  measured.irisDiameter = 0.5 * (find.at("3.1").y() - find.at("3.3").y() + find.at("3.2").y() - find.at("3.4").y());
  measured.eyeSeparation = face.leftPupil.x() - face.rightPupil.x();
  measured.eyeNoseSeparation = 0.5 * (face.leftPupil.y() + face.rightPupil.y()) - noseBase;
  measured.mouthNoseSeparation = noseBase - find.at("2.2").y();
  measured.mouthWidth = find.at("8.3").x() - find.at("8.4").x();
  if (!find.missing().empty())
    return "the face has no feature point " + find.missing() + ", which the FAP units need; add it to FeatureId";
  const std::string fault = describeUnitFault(measured);
  if (fault.empty()) units = measured;
  return fault;
}

}  // namespace mien
