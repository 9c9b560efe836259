#include "PictureFit.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <complex>

#include "NumberText.h"
#include "Similarity.h"
#include "SmoothWarp.h"

namespace mien {

namespace {

using PicturePoints = SmoothWarp::Points;

constexpr double largestPictureMisfit = 0.25;  // eye distances, RMS; frontal faces reach 0.1
constexpr double largestTilt = 60.0 * M_PI / 180.0;
constexpr int anchors = 12;
constexpr double anchorDistance = 2.5;  // of the landmarks' mean distance from their middle

PicturePoints flat(const FaceLandmarks& landmarks) {
  return landmarks.points.leftCols(2);
}

/// The similarity of the plane, never a reflection, from the known landmarks to others, as one complex factor.
Similarity planeFit(const FaceLandmarks& known, const PicturePoints& to) {
  const PicturePoints from = flat(known);
  const Eigen::RowVectorXd start = from.colwise().mean(), end = to.colwise().mean();
  std::complex<double> product = 0.0;
  double squares = 0.0;
  for (Eigen::Index i = 0; i < from.rows(); ++i) {
    const std::complex<double> a(from(i, 0) - start[0], from(i, 1) - start[1]), b(to(i, 0) - end[0], to(i, 1) - end[1]);
    product += std::conj(a) * b;
    squares += std::norm(a);
  }
  Similarity fit;
  fit.scale = std::abs(product) / squares;
  fit.rotation = Eigen::AngleAxisd(std::arg(product), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d middle(start[0], start[1], 0.0);
  fit.translation = Eigen::Vector3d(end[0], end[1], 0.0) - fit.scale * (fit.rotation * middle);
  return fit;
}

struct Reading {
  PicturePoints picture;  ///< y up
  Similarity motion;      ///< known face to picture
  double misfit;          ///< in eye distances

  double tilt() const { return std::atan2(motion.rotation(1, 0), motion.rotation(0, 0)); }
};

Reading readAs(const FaceLandmarks& known, const FaceLandmarks& picture, bool yDown) {
  Reading reading{flat(picture), {}, 0.0};
  if (yDown) reading.picture.col(1) *= -1.0;
  reading.motion = planeFit(known, reading.picture);
  Similarity::Points placed = known.points;
  placed.col(2).setZero();
  const PicturePoints rest = reading.motion.applied(placed).leftCols(2) - reading.picture;
  const double eyes = reading.motion.scale * eyeDistance(known);
  reading.misfit = eyes > 0.0 ? std::sqrt(rest.squaredNorm() / FaceLandmarks::count) / eyes : 1e9;
  return reading;
}

std::string describeReading(const Reading& reading) {
  const std::string advice =
      "; give the 68 landmarks of a frontal face, 0-16 the jaw from the subject's right, see mien adapt --help";
  if (!(reading.misfit <= largestPictureMisfit))
    return "the landmarks are no frontal face: they lie " + roundedText(reading.misfit) +
           " eye distances (RMS) from those of the known face, at most " + roundedText(largestPictureMisfit) +
           " are allowed" + advice;
  if (std::abs(reading.tilt()) > largestTilt)
    return "the face leans by " + roundedText(reading.tilt() * 180.0 / M_PI) + " degrees, more than " +
           roundedText(largestTilt * 180.0 / M_PI) +
           "; turn the picture upright, and mirror a mirrored one back, or say which way y grows with --y-down or "
           "--y-up";
  return {};
}

std::string chooseReading(const FaceLandmarks& known, const FaceLandmarks& picture, const PictureSettings& settings,
                          Reading& best, bool& down) {
  using Vertical = PictureSettings::Vertical;
  const Reading up = readAs(known, picture, false), turned = readAs(known, picture, true);
  down = settings.y == Vertical::Down || (settings.y == Vertical::Recognised && turned.misfit < up.misfit);
  best = down ? turned : up;
  return describeReading(best);
}

/// The picture's landmarks in mm, upright, where the known face's are.
FaceLandmarks placed(const Reading& reading, const FaceLandmarks& known, const PictureSettings& settings,
                     double millimetres) {
  Similarity back;
  if (settings.upright) back.rotation = reading.motion.rotation.transpose();
  Similarity::Points points = Similarity::Points::Zero(FaceLandmarks::count, 3);
  points.leftCols(2) = millimetres * reading.picture;
  points = back.applied(points);
  const Eigen::RowVector2d shift = known.points.leftCols(2).colwise().mean() - points.leftCols(2).colwise().mean();
  points.leftCols(2).rowwise() += shift;
  FaceLandmarks result;
  result.points = points;
  return result;
}

/// The known landmarks and a ring around them that moves with the nearest affine map, and where they go.
struct Warping {
  PicturePoints from, to;
};

Warping warpingOf(const FaceLandmarks& known, const FaceLandmarks& target) {
  const PicturePoints a = flat(known), b = flat(target);
  Eigen::MatrixXd basis(a.rows(), 3);
  basis << a, Eigen::VectorXd::Ones(a.rows());
  const Eigen::MatrixXd affine = basis.colPivHouseholderQr().solve(b);
  const Eigen::RowVector2d middle = a.colwise().mean();
  const double radius = anchorDistance * (a.rowwise() - middle).rowwise().norm().mean();
  Warping warping{PicturePoints(a.rows() + anchors, 2), PicturePoints(a.rows() + anchors, 2)};
  warping.from.topRows(a.rows()) = a;
  warping.to.topRows(a.rows()) = b;
  for (int i = 0; i < anchors; ++i) {
    const double angle = 2.0 * M_PI * (i + 0.5) / anchors;
    const Eigen::RowVector2d p = middle + radius * Eigen::RowVector2d(std::cos(angle), std::sin(angle));
    warping.from.row(a.rows() + i) = p;
    warping.to.row(a.rows() + i) = Eigen::RowVector3d(p.x(), p.y(), 1.0) * affine;
  }
  return warping;
}

Eigen::Vector3d warped(const SmoothWarp& warp, const Eigen::Vector3d& p, double depthScale) {
  const Eigen::VectorXd image = warp(p.head<2>());
  return {image[0], image[1], depthScale * p.z()};
}

}  // namespace

std::string fitToPicture(const FaceCurves& known, const FaceLandmarks& knownLandmarks, const FaceLandmarks& picture,
                         const PictureSettings& settings, FaceCurves& face, PictureReport& report) {
  Reading reading;
  PictureReport found;
  std::string fault = chooseReading(knownLandmarks, picture, settings, reading, found.yDown);
  if (!fault.empty()) return fault;
  found.misfit = reading.misfit;
  found.tilt = reading.tilt();
  found.millimetres = settings.millimetres > 0.0 ? settings.millimetres : 1.0 / reading.motion.scale;
  found.landmarks = placed(reading, knownLandmarks, settings, found.millimetres);
  if (settings.symmetric) found.landmarks = symmetrised(found.landmarks);
  const Warping warping = warpingOf(knownLandmarks, found.landmarks);
  const SmoothWarp warp(warping.from, warping.to);
  if (!warp.sound())
    return "some landmarks of the picture coincide, so that no map takes the face there; give each a place of its own";
  const double depthScale = found.millimetres * reading.motion.scale;
  FaceCurves fitted = known;
  for (Eigen::Index i = 0; i < fitted.curves.points.rows(); ++i) {
    const Eigen::Vector3d p = known.curves.points.row(i).transpose();
    fitted.curves.points.row(i) = warped(warp, p, depthScale).transpose();
    if (!(warp.derivative(p.head<2>()).determinant() > 0.0))
      return "the landmarks fold the face over at (" + roundedText(p.x()) + ", " + roundedText(p.y()) +
             ") mm; some are swapped or misplaced";
  }
  if (known.hasPupils) {
    fitted.leftPupil = warped(warp, known.leftPupil, depthScale);
    fitted.rightPupil = warped(warp, known.rightPupil, depthScale);
  }
  fault = describeFault(fitted);
  if (!fault.empty()) return "the landmarks make " + fault + "; some are swapped or misplaced";
  double squares = 0.0;
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    const Eigen::Vector3d p = warped(warp, knownLandmarks[i], depthScale);
    squares += (p.head<2>() - found.landmarks[i].head<2>()).squaredNorm();
    found.landmarks.points(i, 2) = p.z();
  }
  found.residual = std::sqrt(squares / FaceLandmarks::count);
  face = std::move(fitted);
  report = found;
  return {};
}

}  // namespace mien
