#include "CurveView.h"

#include <vtkActor.h>
#include <vtkBoundaryCurveReader.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkIdList.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

#include "CurveMovement.h"
#include "FaceModel.h"
#include "MotionReach.h"
#include "PropertyColor.h"
#include "RoundedUp.h"
#include "Theme.h"

namespace mien {

namespace {

// Of the pixels between points or curves, within limits in pixels: what is small is drawn finely, not left out.
constexpr double lineShare = 0.1, pointShare = 0.3, neutralShare = 0.5;
constexpr double thinnest = 1.0, thickest = 2.0, smallest = 2.0, largest = 5.0;
constexpr int colorSteps = 256;
constexpr double neutralBehind = 150.0, skinBehind = 600.0;  // depth units behind the curves
constexpr double steepNeutral = 2.0, steepBehind = 4.0;      // pixels of slope, where the skin is seen from the side

constexpr double leastRange = 2.0;  // mm: a twitch does not look like a grin

/// The mapper of the curves, coloured by `Movement`.
vtkSmartPointer<vtkPolyDataMapper> curveMapper(vtkPolyData* curves, vtkLookupTable* colors) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(curves);
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Movement");
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(colors);
  mapper->UseLookupTableScalarRangeOn();
  return mapper;
}

/// Between curves above each other, or between points of one if those are nearer, in mm.
double spacingOf(vtkPolyData* curves) {
  double length = 0.0;
  vtkIdType segments = 0;
  vtkNew<vtkIdList> line;
  for (vtkIdType cell = 0; cell < curves->GetLines()->GetNumberOfCells(); ++cell) {
    curves->GetLines()->GetCellAtId(cell, line);
    for (vtkIdType i = 1; i < line->GetNumberOfIds(); ++i, ++segments) {
      double a[3], b[3];
      curves->GetPoint(line->GetId(i - 1), a);
      curves->GetPoint(line->GetId(i), b);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
    }
  }
  if (segments == 0) return 0.0;
  const double* bounds = curves->GetBounds();
  const double gaps = std::max<double>(1.0, curves->GetLines()->GetNumberOfCells() - 1.0);
  return std::min(length / segments, (bounds[3] - bounds[2]) / gaps);
}

}  // namespace

CurveView::CurveView(FaceModel* model, QWidget* parent) : RenderView(model, parent) {
  setObjectName("curveView");
  setToolTip(tr("The 29 boundary curves; colour says how far they have moved from the neutral face, in mm"));
  addSkin();
  addNeutral();
  addCurves();
  dress();
  connect(model, &FaceModel::updated, this, &CurveView::follow);
  renderer()->AddObserver(vtkCommand::StartEvent, this, &CurveView::sizeDrawing);
  follow();
}

CurveView::~CurveView() = default;

void CurveView::addCurves() {
  colors_->SetNumberOfTableValues(colorSteps);
  lines_->SetMapper(curveMapper(curves_, colors_));
  points_->SetMapper(curveMapper(curves_, colors_));
  points_->GetProperty()->SetRepresentationToPoints();
  points_->GetProperty()->RenderPointsAsSpheresOn();
  for (vtkActor* actor : {lines_.Get(), points_.Get()}) {
    actor->GetProperty()->LightingOff();
    renderer()->AddActor(actor);
  }
}

/// Behind the curves by more than their depths are rounded: where nothing has moved, both lie at one place.
void CurveView::addNeutral() {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(model().pipeline().neutralCurves()->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(steepNeutral, neutralBehind);
  neutral_->SetMapper(mapper);
  neutral_->GetProperty()->LightingOff();
  renderer()->AddActor(neutral_);
}

/// Drawn in a plain colour and a little further away than it is, so that it hides only what is behind the face: between
/// its samples a curve lies within the skin.
void CurveView::addSkin() {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(model().pipeline().surface()->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(steepBehind, skinBehind);
  skin_->SetMapper(mapper);
  skin_->GetProperty()->LightingOff();
  mouth_.setBehind(skinBehind);
  renderer()->AddActor(skin_);
}

/// Without FAPs to move it, a face has no displacements.
void CurveView::follow() {
  auto* shown = vtkPolyData::SafeDownCast(model().pipeline().shownCurves()->GetOutputDataObject(0));
  if (!shown) return;
  mouth_.follow(model().mouth());
  curves_->ShallowCopy(shown);
  spacing_ = spacingOf(shown);
  const auto movement = curveMovement(shown, !withHead_);
  if (movement) curves_->GetPointData()->AddArray(movement);
  most_ = movement && movement->GetNumberOfTuples() > 0 ? movement->GetRange()[1] : 0.0;
  followRange();
}

/// What the frames of an animation reach is known, but for few that mix what others do apart, and for a stream.
void CurveView::followRange() {
  FaceState motion = model().state();
  motion.frame = 0.0;
  if (motion != motion_) played_ = 0.0;
  motion_ = motion;
  played_ = std::max(played_, most_);
  automatic_ = roundedUp(std::max({leastRange, played_, model().reach().movement(withHead_)}));
  showRange();
}

void CurveView::showRange() {
  colors_->SetTableRange(0.0, rangeEnd());
  redraw();
  emit movementChanged();
}

double CurveView::rangeEnd() const {
  return fixed_ > 0.0 ? fixed_ : automatic_;
}

void CurveView::setWithHead(bool on) {
  withHead_ = on;
  played_ = 0.0;
  follow();
}

void CurveView::setFixedRange(double end) {
  fixed_ = end;
  showRange();
}

void CurveView::dress() {
  const Theme& theme = Theme::current();
  for (int i = 0; i < colorSteps; ++i) {
    const double t = i / (colorSteps - 1.0), s = 1.0 - t;
    colors_->SetTableValue(i, s * theme.curve.redF() + t * theme.curveMoved.redF(),
                           s * theme.curve.greenF() + t * theme.curveMoved.greenF(),
                           s * theme.curve.blueF() + t * theme.curveMoved.blueF());
  }
  colors_->Modified();
  setColor(neutral_->GetProperty(), theme.ghost);
  setColor(lines_->GetProperty(), theme.curve);
  setColor(points_->GetProperty(), theme.curve);
  setColor(skin_->GetProperty(), theme.viewBottom);
  renderer()->GradientBackgroundOff();  // what hides the back has one colour, and would show before two
  mouth_.setColor(theme.viewBottom);
}

void CurveView::setPointsVisible(bool visible) {
  points_->SetVisibility(visible);
  redraw();
}

/// Before each picture, as the camera may have moved, or the picture be an enlarged one.
void CurveView::sizeDrawing() {
  const double enlarged = 1.0 * renderer()->GetSize()[1] / std::max(1, height()), spacing = pixelsBetween();
  const double width = enlarged * std::clamp(lineShare * spacing, thinnest, thickest);
  lines_->GetProperty()->SetLineWidth(static_cast<float>(width));
  neutral_->GetProperty()->SetLineWidth(static_cast<float>(std::max(enlarged * thinnest, neutralShare * width)));
  points_->GetProperty()->SetPointSize(
      static_cast<float>(enlarged * std::clamp(pointShare * spacing, smallest, largest)));
}

double CurveView::pixelsBetween() const {
  const double extent =
      2.0 * camera()->GetDistance() * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera()->GetViewAngle()));
  return spacing_ * height() / std::max(1e-9, extent);
}

void CurveView::setNeutralVisible(bool visible) {
  neutral_->SetVisibility(visible);
  redraw();
}

void CurveView::setBackHidden(bool hidden) {
  skin_->SetVisibility(hidden);
  mouth_.setVisible(hidden);
  redraw();
}

void CurveView::useTheme() {
  RenderView::useTheme();
  dress();
}

}  // namespace mien
