#include "FaceAcquisition.h"

#include <algorithm>
#include <cmath>

#include "EarlessSkin.h"
#include "FaceFeatures.h"
#include "FaceLayout.h"
#include "FaceProfiles.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double frontDensity = 0.6;

/// Heights the curves can reach, with a margin for the smoothing of the back.
EarlessSkin skinBetweenCurves(const RadialSkin& skin, const FaceProfiles& profiles) {
  constexpr double margin = 10.0;
  return EarlessSkin(skin, profiles.height(FaceLayout::curveCount - 1, 0.0) - margin, profiles.height(0, 0.0) + margin);
}

/// A ray below the tip of a nose can leave the skin in a nostril. Between its wings a nose only narrows outwards: a
/// place that lies deeper than one further out is in a nostril, and gets the radius of the straight line from rim to
/// rim.
class NoseWings {
 public:
  NoseWings(const FaceLandmarks& landmarks, const HeadAxis& axis, bool open)
      : open_(open),
        right_(wider * axis.azimuth(landmarks[31])),
        left_(wider * axis.azimuth(landmarks[35])),
        low_(landmarks[33].y() - margin),
        high_(landmarks[30].y() + margin) {}

  double radius(const EarlessSkin& skin, double azimuth, double y) const {
    const double here = skin.radius(azimuth, y);
    if (open_ || !(y > low_ && y < high_)) return here;
    const double side = azimuth < 0.0 ? -1.0 : 1.0, limit = side * (side < 0.0 ? right_ : left_);
    const auto at = [&](double aside) { return Rim{aside, skin.radius(side * aside, y)}; };
    const double aside = side * azimuth;
    Rim outer{aside, here};
    for (double further = aside + step; further < limit; further += step)
      if (const Rim other = at(further); other.radius > outer.radius) outer = other;
    if (outer.aside <= aside) return here;
    Rim inner = at(std::max(0.0, aside - step));
    while (inner.aside > 0.0 && inner.radius < outer.radius) inner = at(std::max(0.0, inner.aside - step));
    for (Rim next = at(std::max(0.0, inner.aside - step)); next.radius > inner.radius * (1.0 + step);)
      inner = next, next = at(std::max(0.0, inner.aside - step));  // up the wall of the nostril
    return inner.radius >= outer.radius ? between(inner, outer, aside) : here;
  }

 private:
  struct Rim {
    double aside, radius;
  };

  static double between(const Rim& a, const Rim& b, double aside) {
    return a.radius * b.radius * std::sin(b.aside - a.aside) /
           (a.radius * std::sin(aside - a.aside) + b.radius * std::sin(b.aside - aside));
  }

  static constexpr double step = M_PI / 360.0;
  static constexpr double wider = 1.6;   // wings reach beyond the nostrils, which the landmarks follow
  static constexpr double margin = 3.0;  // mm
  bool open_;                            ///< nostrils stay as they are
  double right_, left_, low_, high_;
};

double sampleRadius(const EarlessSkin& skin, const NoseWings& nose, const FaceProfiles& profiles, int curve,
                    double azimuth, double y) {
  const bool lips = curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip;
  const double w = lips ? profiles.lipWeight(azimuth) : 0.0;
  const double contact = w > 0.0 ? w * profiles.lipRadius(azimuth) : 0.0;
  return w < 1.0 ? contact + (1.0 - w) * nose.radius(skin, azimuth, y) : contact;
}

/// Where a scan ends at a rim near the outermost curves, they run along the rim: the nearest height towards the face's
/// middle that has skin.
double heightWithSkin(const EarlessSkin& skin, double azimuth, double y, double middle) {
  constexpr double farthest = 15.0, step = 0.5, exactly = 0.01;  // mm
  if (std::isfinite(skin.radius(azimuth, y))) return y;
  const double way = y > middle ? -1.0 : 1.0;
  double out = 0.0, in = step;
  while (in <= farthest && !std::isfinite(skin.radius(azimuth, y + way * in))) in += step;
  if (in > farthest) return y;
  out = in - step;
  while (in - out > exactly) {
    const double half = 0.5 * (in + out);
    (std::isfinite(skin.radius(azimuth, y + way * half)) ? in : out) = half;
  }
  return y + way * in;
}

std::string missingSkin(int curve, int j, double y) {
  return "the scan has no skin at point " + std::to_string(j) + " of curve " + FaceLayout::curveName(curve) +
         " (height " + roundedText(y) + " mm); the head must be whole all around";
}

std::string sampleCurves(const EarlessSkin& skin, const NoseWings& nose, const FaceProfiles& profiles,
                         ClosedCurves& curves) {
  const double middle = 0.5 * (profiles.height(0, 0.0) + profiles.height(curves.count - 1, 0.0));
  for (int c = 0; c < curves.count; ++c)
    for (int j = 0; j < curves.pointsPerCurve; ++j) {
      const double azimuth = sampleAzimuth(2.0 * M_PI * j / curves.pointsPerCurve);
      const bool outermost = c < 4 || c >= curves.count - 4;
      const double wanted = profiles.height(c, azimuth),
                   y = outermost ? heightWithSkin(skin, azimuth, wanted, middle) : wanted;
      const double radius = sampleRadius(skin, nose, profiles, c, azimuth, y);
      if (!std::isfinite(radius)) return missingSkin(c, j, y);
      curves.curve(c).row(j) = skin.axis().point(azimuth, y, radius);
    }
  return {};
}

/// Lid margins touch the eyeball: their mean depth is that of the pupil, the eye corners' middle its place.
Eigen::Vector3d pupil(const FaceLandmarks& landmarks, int firstEyeLandmark) {
  const int e = firstEyeLandmark;
  const Eigen::Vector3d middle = 0.5 * (landmarks[e] + landmarks[e + 3]);
  const double depth = 0.25 * (landmarks[e + 1] + landmarks[e + 2] + landmarks[e + 4] + landmarks[e + 5]).z();
  return {middle.x(), middle.y(), depth};
}

bool sameAddresses(const FaceCurves& a, const FaceCurves& b) {
  return std::equal(a.features.begin(), a.features.end(), b.features.begin(), b.features.end(),
                    [](const FeaturePoint& p, const FeaturePoint& q) { return p.id == q.id && p.curve == q.curve; });
}

void add(FaceCurves& sum, const FaceCurves& face, double weight) {
  sum.curves.points += weight * face.curves.points;
  for (std::size_t i = 0; i < sum.features.size(); ++i) sum.features[i].v += weight * face.features[i].v;
  sum.leftPupil += weight * face.leftPupil;
  sum.rightPupil += weight * face.rightPupil;
}

Eigen::Vector3d mirrored(const Eigen::Vector3d& p) {
  return {-p.x(), p.y(), p.z()};
}

}  // namespace

double sampleAzimuth(double v) {
  const double t = v - M_PI;
  return t - frontDensity * std::sin(t);
}

std::string acquireFace(const TriangleMesh& mesh, const FaceLandmarks& landmarks, int pointsPerCurve, FaceCurves& face,
                        bool nostrils) {
  for (const std::string& fault : {describeFault(mesh), describeFault(landmarks)})
    if (!fault.empty()) return fault;
  const FaceProfiles profiles(landmarks);
  const RadialSkin skin(mesh, profiles.axis());
  FaceCurves measured;
  measured.curves = ClosedCurves(FaceLayout::curveCount, pointsPerCurve);
  std::string fault = sampleCurves(skinBetweenCurves(skin, profiles), NoseWings(landmarks, profiles.axis(), nostrils),
                                   profiles, measured.curves);
  if (!fault.empty()) return fault;
  measured.leftPupil = pupil(landmarks, 42);
  measured.rightPupil = pupil(landmarks, 36);
  measured.hasPupils = true;
  measured.features = locateFeatures(measured.curves, landmarks);
  fault = describeFault(measured);
  if (fault.empty()) face = std::move(measured);
  return fault;
}

std::string meanFace(const std::vector<FaceCurves>& faces, FaceCurves& mean) {
  if (faces.empty()) return "there is no face to average";
  FaceCurves sum = faces.front();
  add(sum, faces.front(), 1.0 / static_cast<double>(faces.size()) - 1.0);
  for (std::size_t i = 1; i < faces.size(); ++i) {
    if (faces[i].curves.pointsPerCurve != sum.curves.pointsPerCurve || !sameAddresses(faces[i], sum))
      return "face " + std::to_string(i) + " has other points per curve or features than face 0";
    add(sum, faces[i], 1.0 / static_cast<double>(faces.size()));
  }
  mean = std::move(sum);
  return {};
}

FaceCurves symmetrised(const FaceCurves& face) {
  FaceCurves result = face;
  const int k = face.curves.pointsPerCurve;
  for (int c = 0; c < face.curves.count; ++c)
    for (int j = 0; j <= k / 2; ++j) {
      const Eigen::Vector3d p = face.curves.curve(c).row(j), q = face.curves.curve(c).row((k - j) % k);
      const Eigen::Vector3d mean = 0.5 * (p + mirrored(q));
      result.curves.curve(c).row(j) = mean;
      result.curves.curve(c).row((k - j) % k) = mirrored(mean);
    }
  for (int c = 0; c < face.curves.count; ++c) result.curves.curve(c)(0, 0) = result.curves.curve(c)(k / 2, 0) = 0.0;
  result.leftPupil = 0.5 * (face.leftPupil + mirrored(face.rightPupil));
  result.rightPupil = mirrored(result.leftPupil);
  return result;
}

}  // namespace mien
