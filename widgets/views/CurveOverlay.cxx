#include "CurveOverlay.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <QEvent>
#include <algorithm>

#include "FaceLayout.h"
#include "FaceModel.h"
#include "LabelSpread.h"
#include "PropertyColor.h"
#include "RenderView.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr float curveWidth = 1.6f;             // pixels
constexpr double curvesTowardsCamera = -60.0;  // depth units by which curves lie before the skin that they are on
const QColor lineColor("#14181d");             // on skin and on colours that say something, in both themes
constexpr int nameFontSize = 9;                // pt
constexpr double leader = 16.0, nameGap = 3.0, nameHeight = 12.0, margin = 8.0,
                 nameWidth = 28.0;  // pixels of the screen, not of the device

bool isRight(int curve) {
  return curve % 2 == 1;
}

}  // namespace

CurveOverlay::CurveOverlay(FaceModel* model, RenderView* view, QObject* parent)
    : QObject(parent), model_(model), view_(view), renderer_(view->renderer()) {
  addCurves();
  addNames();
  useTheme();
  started_ = renderer_->AddObserver(vtkCommand::StartEvent, this, &CurveOverlay::prepare);
  view_->installEventFilter(this);
}

CurveOverlay::~CurveOverlay() {
  renderer_->RemoveObserver(started_);
}

void CurveOverlay::addCurves() {
  curveMapper_->SetInputConnection(model_->pipeline().shownCurves()->GetOutputPort());
  curveMapper_->ScalarVisibilityOff();
  curveMapper_->SetResolveCoincidentTopologyToPolygonOffset();
  curveMapper_->SetRelativeCoincidentTopologyLineOffsetParameters(0.0, curvesTowardsCamera);
  curves_->SetMapper(curveMapper_);
  curves_->GetProperty()->LightingOff();
  curves_->GetProperty()->SetLineWidth(curveWidth);
  curves_->VisibilityOff();
  view_->renderer()->AddActor(curves_);
}

void CurveOverlay::addNames() {
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < count; ++i) {
    const vtkIdType ends[] = {2 * i, 2 * i + 1};
    lines->InsertNextCell(2, ends);
    vtkTextProperty* text = names_[i]->GetTextProperty();
    text->SetVerticalJustificationToCentered();
    isRight(static_cast<int>(i)) ? text->SetJustificationToLeft() : text->SetJustificationToRight();
    text->SetFontSize(nameFontSize);
    names_[i]->SetInput(FaceLayout::curveName(static_cast<int>(i)).c_str());
    names_[i]->VisibilityOff();
    view_->renderer()->AddActor2D(names_[i]);
  }
  leaderPoints_->SetNumberOfPoints(2 * count);
  leaderLines_->SetPoints(leaderPoints_);
  leaderLines_->SetLines(lines);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(leaderLines_);
  leaders_->SetMapper(mapper);
  leaders_->VisibilityOff();
  view_->renderer()->AddActor2D(leaders_);
}

void CurveOverlay::useTheme() {
  const Theme& theme = Theme::current();
  leaders_->GetProperty()->SetColor(theme.faintText.redF(), theme.faintText.greenF(), theme.faintText.blueF());
  for (const auto& name : names_)
    name->GetTextProperty()->SetColor(theme.text.redF(), theme.text.greenF(), theme.text.blueF());
}

void CurveOverlay::setCurvesVisible(bool visible) {
  curves_->SetVisibility(visible);
  view_->redraw();
}

void CurveOverlay::setNamesVisible(bool visible) {
  named_ = visible;
  for (const auto& name : names_) name->SetVisibility(visible);
  leaders_->SetVisibility(visible);
  view_->redraw();
}

/// Before each picture, as the camera and the mesh of the face may have changed. Over lines alone the background is
/// what curves are seen on.
void CurveOverlay::prepare() {
  setColor(curves_->GetProperty(), view_->showsSurface() ? lineColor : Theme::current().text);
  placeNames();
}

void CurveOverlay::placeNames() {
  auto* curves = vtkPolyData::SafeDownCast(model_->pipeline().shownCurves()->GetOutputDataObject(0));
  if (!named_ || !curves || curves->GetNumberOfPoints() < count) return;
  const Places places = outermost(curves);
  for (bool right : {false, true}) placeSide(right, places);
  leaderPoints_->Modified();
}

/// Of each curve its point that is seen furthest out on the side of its name.
CurveOverlay::Places CurveOverlay::outermost(vtkPolyData* curves) const {
  Places places;
  vtkRenderer* renderer = view_->renderer();
  const vtkIdType perCurve = curves->GetNumberOfPoints() / count;
  for (int i = 0; i < count; ++i)
    for (vtkIdType k = 0; k < perCurve; ++k) {
      double point[4] = {0.0, 0.0, 0.0, 1.0};
      curves->GetPoint(i * perCurve + k, point);
      renderer->SetWorldPoint(point);
      renderer->WorldToDisplay();
      const double* at = renderer->GetDisplayPoint();
      if (k == 0 || (isRight(i) ? at[0] > places[i][0] : at[0] < places[i][0])) places[i] = {at[0], at[1]};
    }
  return places;
}

/// From the lowest up, apart from each other and within the view.
std::vector<double> CurveOverlay::heights(const std::vector<int>& curves, const Places& places) const {
  const double pixel = view_->devicePixelRatioF(), height = view_->renderer()->GetSize()[1];
  const double low = (margin + view_->foot()) * pixel, top = height - margin * pixel;
  const double apart = std::min(nameHeight * pixel, (top - low) / curves.size());
  std::vector<double> wanted;
  for (size_t i = 0; i < curves.size(); ++i)
    wanted.push_back(std::clamp(places[curves[i]][1], low + apart * i,
                                std::max(low + apart * i, top - apart * (curves.size() - 1 - i))));
  std::sort(wanted.begin(), wanted.end());
  return spreadLabels(wanted, apart);
}

void CurveOverlay::placeSide(bool right, const Places& places) {
  std::vector<int> curves;
  for (int i = right ? 1 : 0; i < count; i += 2) curves.push_back(i);
  std::sort(curves.begin(), curves.end(), [&](int a, int b) { return places[a][1] < places[b][1]; });
  const std::vector<double> levels = heights(curves, places);
  const double pixel = view_->devicePixelRatioF(), side = right ? 1.0 : -1.0;
  for (size_t i = 0; i < curves.size(); ++i) {
    const int curve = curves[i];
    const double edge = pixel * nameWidth, wanted = places[curve][0] + side * pixel * leader;
    const double x = std::clamp(wanted, edge, std::max(edge, view_->renderer()->GetSize()[0] - edge));
    leaderPoints_->SetPoint(2 * curve, places[curve][0], places[curve][1], 0.0);
    leaderPoints_->SetPoint(2 * curve + 1, x, levels[i], 0.0);
    names_[curve]->SetDisplayPosition(std::lround(x + side * pixel * nameGap), std::lround(levels[i]));
  }
}

bool CurveOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange) useTheme();
  return QObject::eventFilter(watched, event);
}

}  // namespace mien
