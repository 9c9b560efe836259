#include <Eigen/Geometry>

#include "CatalogueFigures.h"
#include "FaceInPupilUnits.h"
#include "FigureContext.h"
#include "PlaneDrawingPainter.h"

namespace mien {

namespace {

// How the face of the example lies in its photograph: turned, shifted, 3.1 pixels per mm.
constexpr double turn = 14.0 * M_PI / 180.0, pixelsPerMillimetre = 3.1;
const Eigen::Vector2d shift(310.0, 420.0);

/// Lines of the face and its pupils in one plane.
struct Pose {
  std::vector<QPolygonF> lines;
  Eigen::Vector2d right, left;  ///< pupils p1 and p2

  Pose moved(const Eigen::Affine2d& by) const {
    Pose pose = *this;
    for (QPolygonF& line : pose.lines)
      for (QPointF& point : line) {
        const Eigen::Vector2d to = by * Eigen::Vector2d(point.x(), point.y());
        point = QPointF(to.x(), to.y());
      }
    pose.right = by * right;
    pose.left = by * left;
    return pose;
  }
};

Pose photographed(FigureContext& context) {
  const FaceCurves face = context.neutralFace();
  const Pose pose = {frontalLines(face, false), face.rightPupil.head<2>(), face.leftPupil.head<2>()};
  return pose.moved(Eigen::Translation2d(shift) * Eigen::Rotation2Dd(turn) * Eigen::Scaling(pixelsPerMillimetre));
}

Pose centred(const Pose& pose) {
  return pose.moved(Eigen::Affine2d(Eigen::Translation2d(-0.5 * (pose.left + pose.right))));
}

Pose upright(const Pose& pose) {
  const Eigen::Vector2d axis = pose.left - pose.right;
  return pose.moved(Eigen::Affine2d(Eigen::Rotation2Dd(-std::atan2(axis.y(), axis.x()))));
}

Pose scaled(const Pose& pose) {
  return pose.moved(Eigen::Affine2d(Eigen::Scaling(2.0 / (pose.left - pose.right).norm())));
}

QPointF pointOf(const Eigen::Vector2d& point) {
  return {point.x(), point.y()};
}

/// The face, its pupils and, through `origin`, the axes.
PlaneDrawing poseDrawing(const Pose& pose, const Eigen::Vector2d& origin, const QString& right, const QString& left) {
  PlaneDrawing drawing;
  addFaceBehind(drawing, pose.lines);
  const QRectF box = drawing.bounds().united(QRectF(pointOf(origin), QSizeF(1e-3, 1e-3)));
  const PlaneStroke axis = {QColor("#222222"), 0.4};
  drawing.lines.push_back(
      {segment(QPointF(box.left(), origin.y()), QPointF(box.right(), origin.y())), axis, false, true});
  drawing.lines.push_back(
      {segment(QPointF(origin.x(), box.top()), QPointF(origin.x(), box.bottom())), axis, false, true});
  const QColor mark("#d55e00");
  drawing.lines.push_back({segment(pointOf(pose.right), pointOf(pose.left)), {mark, 0.7}});
  for (const auto& [at, name] : {std::pair(pose.right, right), {pose.left, left}}) {
    drawing.marks.push_back({pointOf(at), 1.6, {mark, 0.5, false, mark}});
    const double above = 0.035 * box.height();
    drawing.labels.push_back({pointOf(at) + QPointF(0.0, above), name, 6.5, Qt::AlignCenter, mark, true});
  }
  return drawing;
}

/// "(231, 402)"
QString inPixels(const Eigen::Vector2d& at) {
  const auto whole = [](double value) { return QString::number(std::lround(value)); };
  return "(" + whole(at.x()) + ", " + whole(at.y()) + ")";
}

/// The pose with the coordinates of its pupils.
PlaneDrawing inPixels(const Pose& pose) {
  return poseDrawing(pose, {0.0, 0.0}, inPixels(pose.right), inPixels(pose.left));
}

PlaneDrawing inPupilUnits(const Pose& pose) {
  return poseDrawing(pose, {0.0, 0.0}, "(-1, 0)", "(1, 0)");
}

}  // namespace

FigureDrawing drawPupils(FigureContext& context) {
  const Pose pose = photographed(context);
  Plate plate;
  plate.panels = {drawingPanel("As recorded, pixels", inPixels(pose)),
                  drawingPanel("In pupil units", inPupilUnits(scaled(upright(centred(pose)))))};
  plate.caption = "The pupils p1 (the subject's right) and p2 give every face the same place, turn and size.";
  return context.drawn(plate);
}

FigureDrawing drawNormalisation(FigureContext& context) {
  const Pose pose = photographed(context), first = centred(pose), second = upright(first), third = scaled(second);
  Plate plate;
  plate.columns = context.isNarrow() ? 2 : 4;
  plate.panels = {
      drawingPanel("Recorded, pixels", inPixels(pose)), drawingPanel("Moved to the midpoint", inPixels(first)),
      drawingPanel("Turned about z", inPixels(second)), drawingPanel("Scaled: pupil units", inPupilUnits(third))};
  plate.caption =
      "Pupil normalisation of a face that was recorded turned by 14 degrees; the axes meet at the origin, the numbers "
      "are "
      "the coordinates of the pupils after each step. The scale is uniform; depth is scaled with it.";
  return context.drawn(plate);
}

}  // namespace mien
