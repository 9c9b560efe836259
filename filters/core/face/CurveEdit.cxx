#include "CurveEdit.h"

#include <cmath>
#include <tuple>

#include "Degree.h"
#include "FaceLayout.h"
#include "NumberText.h"

namespace mien {

namespace {

constexpr double midlineTolerance = 1e-9;  // radians

/// 1 at 0, 0 from 1 on, smooth.
double fallOff(double t) {
  return std::abs(t) < 1.0 ? std::pow(std::cos(0.5 * M_PI * t), 2) : 0.0;
}

/// Curves counted down the face; the two inner lip contours are one step.
int step(int curve) {
  return curve < FaceLayout::lowerLip ? curve : curve - 1;
}

/// How much samples follow an edit: curve by curve, and along v on either side.
class Influence {
 public:
  Influence(const CurveEdit& edit, const FaceCurves& face) : edit_(edit), face_(face) {}

  double ofCurve(int curve, int j) const {
    const bool lips = isLip(curve) && isLip(edit_.curve) && curve != edit_.curve;
    if (lips && !closed(j)) return edit_.spread > 0 ? fallOff(1.0 / (edit_.spread + 1.0)) : 0.0;
    return fallOff((step(curve) - step(edit_.curve)) / (edit_.spread + 1.0));
  }

  Eigen::Vector3d moveAt(double v) const {
    const double here = fallOff(std::remainder(v - edit_.v, 2.0 * M_PI) / edit_.width);
    if (!edit_.mirrored || std::abs(std::sin(edit_.v)) < midlineTolerance) return here * edit_.move;
    const double there = fallOff(std::remainder(v + edit_.v, 2.0 * M_PI) / edit_.width);
    const double both = 1.0 + fallOff(std::remainder(2.0 * edit_.v, 2.0 * M_PI) / edit_.width);
    const Eigen::Vector3d mirrored(-edit_.move.x(), edit_.move.y(), edit_.move.z());
    return (here * edit_.move + there * mirrored) / both;
  }

 private:
  static bool isLip(int curve) { return curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip; }
  bool closed(int j) const {
    return face_.curves.curve(FaceLayout::upperLip).row(j) == face_.curves.curve(FaceLayout::lowerLip).row(j);
  }

  const CurveEdit& edit_;
  const FaceCurves& face_;
};

ClosedCurves displacementOf(const CurveEdit& edit, const FaceCurves& face) {
  const int k = face.curves.pointsPerCurve;
  const Influence influence(edit, face);
  ClosedCurves displacement(face.curves.count, k);
  for (int j = 0; j < k; ++j) {
    const Eigen::RowVector3d move = influence.moveAt(2.0 * M_PI * j / k).transpose();
    for (int c = 0; c < face.curves.count; ++c) displacement.curve(c).row(j) = influence.ofCurve(c, j) * move;
  }
  return displacement;
}

/// The mean displacement of the lids above and below a pupil.
Eigen::Vector3d lidMove(const ClosedCurves& displacement, const FaceCurves& face, const char* upper,
                        const char* lower) {
  const FeaturePoint* a = face.feature(upper);
  const FeaturePoint* b = face.feature(lower);
  if (!a || !b) return Eigen::Vector3d::Zero();
  return 0.5 * (displacement.at(a->curve, a->v) + displacement.at(b->curve, b->v));
}

std::string nameOf(const CurveEdit& edit, size_t number) {
  const bool known = edit.curve >= 0 && edit.curve < FaceLayout::curveCount;
  return "edit " + std::to_string(number + 1) + (known ? " (" + FaceLayout::curveName(edit.curve) + ")" : "") + ": ";
}

std::string apply(const CurveEdit& edit, FaceCurves& face) {
  const std::string fault = describeFault(edit, face.curves.pointsPerCurve);
  if (!fault.empty()) return fault;
  const ClosedCurves displacement = displacementOf(edit, face);
  face.curves.points += displacement.points;
  if (face.hasPupils) {
    face.leftPupil += lidMove(displacement, face, "3.1", "3.3");
    face.rightPupil += lidMove(displacement, face, "3.2", "3.4");
  }
  return describeFault(face);
}

}  // namespace

CurveEdit CurveEdit::ofPoint(int curve, int point, int pointsPerCurve) {
  CurveEdit edit;
  edit.curve = curve;
  edit.v = 2.0 * M_PI * point / pointsPerCurve;
  return edit;
}

double CurveEdit::vDegrees() const {
  return v / degree;
}

double CurveEdit::widthDegrees() const {
  return width / degree;
}

void CurveEdit::setWidthDegrees(double degrees) {
  width = degrees * degree;
}

bool CurveEdit::operator==(const CurveEdit& other) const {
  return std::tie(curve, v, width, spread, mirrored) ==
             std::tie(other.curve, other.v, other.width, other.spread, other.mirrored) &&
         move == other.move;
}

std::string describeFault(const CurveEdit& edit, int pointsPerCurve) {
  if (edit.curve < 0 || edit.curve >= FaceLayout::curveCount)
    return "there is no such curve; they are C1 .. C28 and C22'";
  if (!(edit.v >= 0.0 && edit.v < 2.0 * M_PI + 1e-12)) return "v = " + numberText(edit.v) + " is outside 0 .. 2 pi";
  if (!edit.move.allFinite() || edit.move.cwiseAbs().maxCoeff() > CurveEdit::largestMove)
    return "a point moves by at most " + numberText(CurveEdit::largestMove) + " mm along each axis";
  const double narrowest = 4.0 * M_PI / pointsPerCurve;
  if (!(edit.width >= narrowest - 1e-9 && edit.width <= M_PI + 1e-9))
    return "width " + numberText(edit.widthDegrees()) + " is outside " + numberText(narrowest / degree) +
           " .. 180 degrees (two points of the curve .. half of it)";
  if (edit.spread < 0 || edit.spread > CurveEdit::largestSpread)
    return "spread " + std::to_string(edit.spread) + " is outside 0 .. " + std::to_string(CurveEdit::largestSpread) +
           " curves";
  return {};
}

std::string applyEdits(const std::vector<CurveEdit>& edits, FaceCurves& face) {
  FaceCurves edited = face;
  for (size_t i = 0; i < edits.size(); ++i) {
    const std::string fault = apply(edits[i], edited);
    if (!fault.empty()) return nameOf(edits[i], i) + fault;
  }
  face = std::move(edited);
  return {};
}

}  // namespace mien
