#include "CameraFlight.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <cmath>

#include "RenderView.h"

namespace mien {

namespace {

constexpr int flightTime = 350;  // ms

using Vector = std::array<double, 3>;

Vector mixed(const Vector& a, const Vector& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

Vector normalized(Vector v) {
  vtkMath::Normalize(v.data());
  return v;
}

}  // namespace

CameraFlight::CameraFlight(RenderView* view, QObject* parent) : QVariantAnimation(parent), view_(view) {
  setStartValue(0.0);
  setEndValue(1.0);
  setDuration(flightTime);
  setEasingCurve(QEasingCurve::InOutCubic);
  connect(this, &QVariantAnimation::valueChanged, this, [this](const QVariant& share) { show(share.toDouble()); });
}

CameraFlight::Place CameraFlight::current() const {
  Place place;
  vtkCamera* camera = view_->camera();
  double position[3];
  camera->GetFocalPoint(place.focus.data());
  camera->GetPosition(position);
  for (int i = 0; i < 3; ++i) place.direction[i] = position[i] - place.focus[i];
  place.direction = normalized(place.direction);
  place.distance = camera->GetDistance();
  return place;
}

void CameraFlight::flyTo(const Vector& focus, const Vector& direction, double extent) {
  stop();
  from_ = current();
  to_ = {focus, normalized(direction), 0.5 * extent / std::tan(view_->camera()->GetViewAngle() * M_PI / 360.0)};
  start();
}

void CameraFlight::show(double share) {
  if (to_.distance <= 0.0) return;  // a value set before the first flight
  const Vector focus = mixed(from_.focus, to_.focus, share),
               direction = normalized(mixed(from_.direction, to_.direction, share));
  view_->placeCamera(focus, direction, from_.distance + share * (to_.distance - from_.distance));
}

}  // namespace mien
