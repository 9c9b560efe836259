#include "DifferenceArrows.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <array>
#include <cmath>
#include <set>

#include "RenderView.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr double spacing = 6.0;  // mm between arrows; doubled until there are few enough
constexpr int most = 1500;
constexpr const char* arrowArray = "Arrow";

/// One point of each cube of space, the first.
std::vector<vtkIdType> spread(vtkPolyData* surface, vtkDataArray* vectors, double longest, double edge) {
  std::set<std::array<int, 3>> taken;
  std::vector<vtkIdType> chosen;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    double point[3], vector[3];
    vectors->GetTuple(i, vector);
    const double length = std::hypot(vector[0], vector[1], vector[2]);
    if (!(length >= DifferenceArrows::leastLength && length <= longest)) continue;
    surface->GetPoint(i, point);
    std::array<int, 3> cube;
    for (int k = 0; k < 3; ++k) cube[k] = static_cast<int>(std::floor(point[k] / edge));
    if (taken.insert(cube).second) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace

DifferenceArrows::DifferenceArrows(RenderView* view, QObject* parent) : QObject(parent), view_(view) {
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(8);
  arrow->SetShaftResolution(6);
  arrow->SetTipLength(0.3);
  arrow->SetTipRadius(0.11);
  arrow->SetShaftRadius(0.035);
  mapper_->SetSourceConnection(arrow->GetOutputPort());
  mapper_->SetInputData(origins_);
  mapper_->SetOrientationArray(arrowArray);
  mapper_->SetScaleArray(arrowArray);
  mapper_->SetScaleModeToScaleByMagnitude();
  mapper_->ScalarVisibilityOff();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->SetAmbient(0.35);
  actor_->GetProperty()->SetDiffuse(0.65);
  actor_->VisibilityOff();
  view_->renderer()->AddActor(actor_);
  view_->installEventFilter(this);
  useTheme();
}

DifferenceArrows::~DifferenceArrows() = default;

void DifferenceArrows::show(vtkPolyData* surface, const char* array, double longest) {
  longest_ = longest;
  surface ? surface_->ShallowCopy(surface) : surface_->Initialize();
  array_ = array;
  draw();
}

void DifferenceArrows::setFactor(double factor) {
  factor_ = factor;
  mapper_->SetScaleFactor(factor);
  draw();
}

int DifferenceArrows::count() const {
  return actor_->GetVisibility() ? static_cast<int>(origins_->GetNumberOfPoints()) : 0;
}

void DifferenceArrows::draw() {
  vtkDataArray* vectors = surface_->GetPointData()->GetArray(array_.c_str());
  actor_->SetVisibility(vectors && factor_ > 0.0);
  if (actor_->GetVisibility()) {
    double edge = spacing;
    std::vector<vtkIdType> chosen = spread(surface_, vectors, longest_, edge);
    while (chosen.size() > most) chosen = spread(surface_, vectors, longest_, edge *= 1.5);
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> arrows;
    arrows->SetName(arrowArray);
    arrows->SetNumberOfComponents(3);
    for (vtkIdType i : chosen) {
      points->InsertNextPoint(surface_->GetPoint(i));
      arrows->InsertNextTuple(vectors->GetTuple(i));
    }
    origins_->SetPoints(points);
    origins_->GetPointData()->Initialize();
    origins_->GetPointData()->AddArray(arrows);
    origins_->Modified();
  }
  view_->redraw();
}

bool DifferenceArrows::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange) useTheme();
  return QObject::eventFilter(watched, event);
}

/// Dark on skin and on the pale colours of a scale.
void DifferenceArrows::useTheme() {
  const QColor& color = Theme::of(Theme::Kind::Light).mesh;
  actor_->GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
}

}  // namespace mien
