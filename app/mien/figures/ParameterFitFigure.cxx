#include "CatalogueFigures.h"
#include "DefaultRegions.h"
#include "FaceInPupilUnits.h"
#include "FaceMotion.h"
#include "FaceNote.h"
#include "Failure.h"
#include "FigureContext.h"
#include "NumberText.h"
#include "PlaneAxes.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"
#include "PupilNormalisation.h"
#include "QuadraticFit.h"
#include "TextTable.h"

namespace mien {

namespace {

constexpr int region = 11;        // the left cheek, which has no slit
constexpr double tickStep = 0.5;  // pupil units
constexpr double frontZ = 40.0;   // mm: beyond it the cheek goes over into the side of the head

/// Points of the region before and after, pupil units.
struct RegionPoints {
  std::vector<Eigen::Vector2d> before, after;

  PlanePoints matrix(const std::vector<Eigen::Vector2d>& points) const {
    PlanePoints rows(points.size(), 2);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
  }
};

RegionPoints pointsOf(const MotionField& field, const PupilNormalisation& pupils) {
  RegionPoints points;
  for (Eigen::Index i = 0; i < field.origins.rows(); ++i) {
    const Eigen::Vector3d at = field.origins.row(i).transpose();
    const Eigen::Vector2d place = pupils.apply(at).head<2>();
    const bool onFace = at.z() > frontZ && defaultRegions().covers(place);
    if (!onFace || defaultRegions().nearest(place) != region) continue;
    points.before.push_back(place);
    points.after.push_back(pupils.apply(at + field.vectors.row(i).transpose()).head<2>());
  }
  return points;
}

PlaneDrawing pointDrawing(const RegionPoints& points) {
  PlaneDrawing drawing;
  const QColor blue("#0072b2"), orange("#d55e00");
  for (std::size_t i = 0; i < points.before.size(); ++i) {
    const QPointF from(points.before[i].x(), points.before[i].y()), to(points.after[i].x(), points.after[i].y());
    drawing.lines.push_back({segment(from, to), {QColor("#888888"), 0.35}});
    drawing.marks.push_back({from, 0.9, {blue, 0.4}});
    drawing.marks.push_back({to, 0.9, {orange, 0.1, false, orange}});
  }
  return drawing;
}

TextTable coefficientTable(const QuadraticMap& map) {
  TextTable table;
  table.size = 7.0;
  table.columns = {{"Term", 1.0}, {"x'", 1.0, true}, {"y'", 1.0, true}};
  const char* const terms[] = {"x²", "xy", "y²", "x", "y", "1"};
  for (int i = 0; i < 6; ++i) {
    const auto cell = [&](int row) {
      return QString("%1%2\u00a0=\u00a0%3")
          .arg(row ? "b" : "a")
          .arg(i + 1)
          .arg(map.coefficients(row, i), 0, 'f', 4)
          .replace('-', "−")
          .toStdString();
    };
    table.rows.push_back({terms[i], cell(0), cell(1)});
  }
  return table;
}

FaceState movedState(FigureContext& context) {
  FaceState state = context.state();
  const bool moves = !state.expressions.empty() || !state.fapValues.empty() || !state.fapFile.empty();
  if (!moves) state.expressions["joy"] = 1.0;
  state.rows = 112;
  state.columns = 80;
  return state;
}

}  // namespace

FigureDrawing drawParameterFit(FigureContext& context) {
  const FaceState moved = movedState(context);
  const FaceCurves face = context.neutralFace();
  PupilNormalisation pupils;
  const std::string fault = pupils.set(face.leftPupil, face.rightPupil);
  if (!fault.empty()) throw FileFailure(fault);
  const RegionPoints points = pointsOf(context.motion(moved, FaceMotion::neutralOf(moved)), pupils);
  if (points.before.size() < 6) throw FileFailure("region 11 of this face holds fewer than six points");
  const QuadraticFit fit = fitQuadraticMap(points.matrix(points.before), points.matrix(points.after));
  Plate plate;
  plate.columns = context.isNarrow() ? 1 : 2;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  PlaneDrawing drawing = pointDrawing(points);
  const QRectF shown = addPlaneAxes(drawing, drawing.bounds(), tickStep, "pupil units", width);
  plate.panels = {drawingPanel("Points of region 11", drawing, shown),
                  tablePanel("The 12 parameters", coefficientTable(fit.map), width)};
  plate.caption =
      "x' = a1 x² + a2 xy + a3 y² + a4 x + a5 y + a6, y' likewise with b1 .. b6, fitted by least squares to " +
      std::to_string(fit.points) +
      " points of the left cheek, before (open circles) and after (dots, joined to them) " + motionText(moved) +
      "; what is left over has an "
      "RMS of " +
      QString::number(fit.rms, 'f', 4).toStdString() + " pupil units.";
  return context.drawn(plate);
}

}  // namespace mien
