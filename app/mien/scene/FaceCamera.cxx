#include "FaceCamera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "vtkCamera.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr double viewAngle = 14.0;  // degrees: a portrait lens, nearly parallel
constexpr double margin = 1.10;     // picture over face
constexpr int refinements = 6;      // each gains about two digits, as the perspective is weak

using Eigen::Vector2d;
using Eigen::Vector3d;

struct Frame {
  Vector3d right, up, out, focus;
  double distance;
};

Frame orientation(const ViewDirection& view) {
  Frame frame;
  view.axes(frame.right.data(), frame.up.data(), frame.out.data());
  return frame;
}

/// Smallest and largest tangents at which the camera sees the surface, across and up.
std::pair<Vector2d, Vector2d> seenExtent(vtkPolyData* surface, const Frame& frame) {
  Vector2d low(1e300, 1e300), high(-1e300, -1e300);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
    Vector3d p;
    surface->GetPoint(i, p.data());
    p -= frame.focus;
    const Vector2d seen = Vector2d(p.dot(frame.right), p.dot(frame.up)) / (frame.distance - p.dot(frame.out));
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  return {low, high};
}

void refine(vtkPolyData* surface, double widthOverHeight, Frame& frame) {
  const auto [low, high] = seenExtent(surface, frame);
  const Vector2d middle = frame.distance * (low + high) / 2.0;
  frame.focus += frame.right * middle[0] + frame.up * middle[1];
  const double height = std::max(high[1] - low[1], (high[0] - low[0]) / widthOverHeight);
  frame.distance *= margin * height / (2.0 * std::tan(viewAngle * M_PI / 360.0));
}

/// Where a camera that was placed stands.
Frame frameOf(const ViewDirection& view, vtkCamera* camera) {
  Frame frame = orientation(view);
  camera->GetFocalPoint(frame.focus.data());
  frame.distance = camera->GetDistance();
  return frame;
}

}  // namespace

bool isWithinFrame(vtkPolyData* surface, const ViewDirection& view, const FaceFrame& wanted, vtkCamera* camera) {
  const auto [low, high] = seenExtent(surface, frameOf(view, camera));
  const double side = std::tan(viewAngle * M_PI / 360.0);
  const Vector2d limit(side * wanted.aspect * wanted.freeShare, side);
  return (low.array() >= -limit.array()).all() && (high.array() <= limit.array()).all();
}

void placeFaceCamera(vtkPolyData* surface, const ViewDirection& view, const FaceFrame& wanted, vtkCamera* camera) {
  Frame frame = orientation(view);
  surface->GetCenter(frame.focus.data());
  frame.distance = surface->GetLength() / std::tan(viewAngle * M_PI / 360.0);
  for (int i = 0; i < refinements; ++i) refine(surface, wanted.aspect * wanted.freeShare, frame);
  camera->SetFocalPoint(frame.focus.data());
  camera->SetPosition(Vector3d(frame.focus + frame.distance * frame.out).data());
  camera->SetViewUp(frame.up.data());
  camera->SetViewAngle(viewAngle);
  camera->SetWindowCenter(1.0 - wanted.freeShare, 0.0);
}

}  // namespace mien
