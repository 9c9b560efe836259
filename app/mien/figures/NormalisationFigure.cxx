#include <Eigen/Geometry>
#include <tuple>

#include "CatalogueFigures.h"
#include "FaceInPupilUnits.h"
#include "FigureContext.h"
#include "PlaneAxes.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"

namespace mien {

namespace {

// How the face of the example lies in its photograph: turned, shifted, 3.1 pixels per mm.
constexpr double turn = 14.0 * M_PI / 180.0, pixelsPerMillimetre = 3.1;
const Eigen::Vector2d shift(310.0, 420.0);
constexpr double labelDistance = 2.4;  // mm on paper, from a pupil to the middle of its name

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

/// A panel of the figures: a drawing and the part of the plane that is seen.
struct PoseDrawing {
  PlaneDrawing drawing;
  QRectF shown;
};

/// How the coordinates of a panel are written.
struct Scale {
  double step;  ///< between ticks
  QString unit;
};

void addPupil(PlaneDrawing& drawing, const Eigen::Vector2d& at, const QString& name, double above) {
  const QColor color("#d55e00");
  drawing.marks.push_back({pointOf(at), 1.6, {color, 0.5, false, color}});
  const QString text =
      QString("%1 (%2, %3)").arg(name).arg(std::lround(at.x())).arg(std::lround(at.y())).replace('-', "−");
  drawing.labels.push_back({pointOf(at) + QPointF(0.0, above), text, 6.0, Qt::AlignCenter, color, true, true});
}

/// The face, the lines x = 0 and y = 0, the pupils with their coordinates, and axes.
///
/// @param width  of the panel, mm
PoseDrawing drawingOf(const Pose& pose, const Scale& scale, double width) {
  PoseDrawing panel;
  PlaneDrawing& drawing = panel.drawing;
  addFaceBehind(drawing, pose.lines);
  const QRectF range = drawing.bounds().united(QRectF(QPointF(), QSizeF(1e-3, 1e-3)));
  PlaneStroke zero;
  zero.width = 0.4;
  zero.dashed = true;
  if (range.left() < 0.0) {  // else the axes lie there
    drawing.lines.push_back({segment({range.left(), 0.0}, {range.right(), 0.0}), zero});
    drawing.lines.push_back({segment({0.0, range.top()}, {0.0, range.bottom()}), zero});
  }
  drawing.lines.push_back({segment(pointOf(pose.right), pointOf(pose.left)), {QColor("#d55e00"), 0.7}});
  const double above = labelDistance * range.width() / width;
  addPupil(drawing, pose.right, "p1", -above);
  addPupil(drawing, pose.left, "p2", above);
  panel.shown = addPlaneAxes(drawing, range, scale.step, scale.unit, width);
  return panel;
}

const Scale pixels = {200.0, "pixels"}, pupilUnits = {1.0, "pupil units"};

}  // namespace

FigureDrawing drawPupils(FigureContext& context) {
  const Pose pose = photographed(context);
  Plate plate;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  const PoseDrawing before = drawingOf(pose, pixels, width);
  const PoseDrawing after = drawingOf(scaled(upright(centred(pose))), pupilUnits, width);
  plate.panels = {drawingPanel("As recorded", before.drawing, before.shown),
                  drawingPanel("Normalised", after.drawing, after.shown)};
  plate.caption = "The pupils p1 (the subject's right) and p2 give every face the same place, turn and size.";
  return context.drawn(plate);
}

FigureDrawing drawNormalisation(FigureContext& context) {
  const Pose pose = photographed(context), first = centred(pose), second = upright(first), third = scaled(second);
  Plate plate;
  plate.columns = context.isNarrow() ? 2 : 4;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  const std::tuple<const char*, Pose, Scale> steps[] = {{"Recorded", pose, pixels},
                                                        {"Moved to the midpoint", first, pixels},
                                                        {"Turned about z", second, pixels},
                                                        {"Scaled", third, pupilUnits}};
  for (const auto& [heading, step, scale] : steps) {
    const PoseDrawing panel = drawingOf(step, scale, width);
    plate.panels.push_back(drawingPanel(heading, panel.drawing, panel.shown));
  }
  plate.caption =
      "Pupil normalisation of a face that was recorded turned by 14 degrees: pupils p1 (the subject's right) and p2 "
      "with "
      "their coordinates after each step; dashed: x = 0 and y = 0. The scale is uniform; depth is scaled with it.";
  return context.drawn(plate);
}

}  // namespace mien
