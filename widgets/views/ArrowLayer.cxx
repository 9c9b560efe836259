#include "ArrowLayer.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double shaftWidth = 2.0, headWidth = 7.0, headLength = 8.0, rim = 1.25;  // pixels
constexpr double shortHead = 0.6;    // of an arrow too short for such a head
constexpr double leastSeen = 3.0;    // pixels, of an arrow that is drawn
constexpr double leastFacing = 0.1;  // cosine between the skin and the way to the camera
constexpr double layerBefore = 1.0,
                 layerStep = 0.002;  // mm: of the layer before the surface, and of each shape before the last
constexpr unsigned char rimColor[] = {20, 24, 29}, fillColor[] = {255, 255, 255};

using Corner = Eigen::Vector2d;

/// The lens of a view: where a point is seen in a plane across it, and where in space that is.
class Lens {
 public:
  explicit Lens(vtkCamera* camera)
      : eye(camera->GetPosition()),
        forward(Eigen::Vector3d(camera->GetDirectionOfProjection()).normalized()),
        right(forward.cross(Eigen::Vector3d(camera->GetViewUp())).normalized()),
        up(right.cross(forward)) {}

  double depth(const Eigen::Vector3d& point) const { return forward.dot(point - eye); }

  Corner seen(const Eigen::Vector3d& point, double plane) const {
    const Eigen::Vector3d way = (point - eye) * (plane / std::max(1e-6, depth(point)));
    return {right.dot(way), up.dot(way)};
  }

  /// Nearer to the eye than the plane, at the same place of the picture.
  Eigen::Vector3d place(const Corner& corner, double plane, double nearer) const {
    return eye + (1.0 - nearer / plane) * (corner.x() * right + corner.y() * up + plane * forward);
  }

  Eigen::Vector3d eye, forward, right, up;
};

double nearestDepth(const Lens& lens, vtkPolyData* surface) {
  double box[6], least = 1e300;
  surface->GetBounds(box);
  for (int corner = 0; corner < 8; ++corner)
    least = std::min(least, lens.depth({box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2)]}));
  return std::max(1.0, least - layerBefore);
}

/// An arrow from `tail` to `tip`, grown by `rim` on all sides.
struct Shape {
  Corner tail, neck, tip, aside;
  double shaft, barb;

  Shape(const Corner& from, const Corner& to, double pixel, double grown) {
    const double length = (to - from).norm(), head = std::min(headLength * pixel, shortHead * length);
    const Corner along = (to - from) / length;
    const double slope = 0.5 * headWidth / headLength;  // of the head's sides
    aside = {-along.y(), along.x()};
    tail = from - grown * along;
    neck = to - (head + grown) * along;
    tip = to + grown * std::hypot(1.0, 1.0 / slope) * along;
    barb = slope * (tip - neck).norm();
    shaft = std::min(0.5 * shaftWidth * pixel, 0.5 * barb) + grown;
  }
};

/// Triangles with a colour each, the later before the earlier.
class Sheet {
 public:
  Sheet(const Lens& lens, double plane) : lens_(lens), plane_(plane) { colors_->SetNumberOfComponents(3); }

  void add(const Shape& shape, const unsigned char* color) {
    nearer_ += layerStep;
    const Corner shaft = shape.shaft * shape.aside, barb = shape.barb * shape.aside;
    add({shape.tail - shaft, shape.neck - shaft, shape.neck + shaft, shape.tail + shaft}, color);
    add({shape.neck - barb, shape.tip, shape.neck + barb}, color);
  }

  void giveTo(vtkPolyData* data) const {
    data->Initialize();
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetCellData()->SetScalars(colors_);
  }

 private:
  void add(const std::vector<Corner>& corners, const unsigned char* color) {
    cells_->InsertNextCell(static_cast<int>(corners.size()));
    for (const Corner& corner : corners)
      cells_->InsertCellPoint(points_->InsertNextPoint(lens_.place(corner, plane_, nearer_).data()));
    colors_->InsertNextTypedTuple(color);
  }

  const Lens& lens_;
  double plane_, nearer_ = 0.0;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

}  // namespace

ArrowLayer::ArrowLayer(vtkRenderer* renderer) : renderer_(renderer) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shapes_);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->LightingOff();
  actor_->VisibilityOff();
  renderer_->AddActor(actor_);
}

void ArrowLayer::setVisible(bool visible) {
  actor_->SetVisibility(visible);
}

void ArrowLayer::draw(const std::vector<Arrow>& arrows, double pixel, vtkPolyData* surface) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const Lens lens(camera);
  const double plane = nearestDepth(lens, surface);
  pixel *= plane / camera->GetDistance();  // as large in the plane as in the middle of the view
  Sheet sheet(lens, plane);
  for (const Arrow& arrow : arrows) {
    const Eigen::Vector3d way = (lens.eye - arrow.tail).normalized();
    if (!arrow.normal.isZero() && arrow.normal.dot(way) < leastFacing) continue;
    const Corner tail = lens.seen(arrow.tail, plane), tip = lens.seen(arrow.tip, plane);
    if (!((tip - tail).norm() >= leastSeen * pixel)) continue;
    sheet.add(Shape(tail, tip, pixel, rim * pixel), rimColor);
    sheet.add(Shape(tail, tip, pixel, 0.0), fillColor);
  }
  sheet.giveTo(shapes_);
}

}  // namespace mien
