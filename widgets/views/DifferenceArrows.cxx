#include "DifferenceArrows.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "RenderView.h"

namespace mien {

namespace {

constexpr double least = 6.0;         // mm between arrows
constexpr double pixelsApart = 18.0;  // the same as it is seen, or else they are further apart
constexpr double furthest = 1000.0;   // mm; a camera may stand anywhere, and a head has one arrow then
constexpr double coarser = 1.5;       // each such distance, of the one before
constexpr size_t most = 1500;

/// Points of which no two are nearer than a distance.
class Spread {
 public:
  explicit Spread(double apart) : apart_(apart) {}

  bool take(const Eigen::Vector3d& point) {
    Cube middle;
    for (int k = 0; k < 3; ++k) middle[k] = std::floor(point[k] / apart_);
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const auto found = taken_.find(
          {middle[0] + neighbour % 3 - 1, middle[1] + neighbour / 3 % 3 - 1, middle[2] + neighbour / 9 - 1});
      if (found == taken_.end()) continue;
      for (const Eigen::Vector3d& other : found->second)
        if ((other - point).norm() < apart_) return false;
    }
    taken_[middle].push_back(point);
    return true;
  }

 private:
  using Cube = std::array<double, 3>;  // whole numbers; a scan may lie further away than an int counts

  double apart_;
  std::map<Cube, std::vector<Eigen::Vector3d>> taken_;
};

}  // namespace

DifferenceArrows::DifferenceArrows(RenderView* view, QObject* parent)
    : QObject(parent), view_(view), renderer_(view->renderer()), layer_(view->renderer()) {
  started_ = renderer_->AddObserver(vtkCommand::StartEvent, this, &DifferenceArrows::prepare);
}

DifferenceArrows::~DifferenceArrows() {
  renderer_->RemoveObserver(started_);
}

void DifferenceArrows::show(vtkPolyData* surface, const char* array, double longest) {
  longest_ = longest;
  surface ? surface_->ShallowCopy(surface) : surface_->Initialize();
  array_ = array;
  choose(apart_);
  view_->redraw();
}

void DifferenceArrows::setFactor(double factor) {
  factor_ = factor;
  choose(apart_);
  view_->redraw();
}

int DifferenceArrows::count() const {
  return static_cast<int>(arrows_.size());
}

void DifferenceArrows::choose(double apart) {
  arrows_.clear();
  vtkDataArray* vectors = factor_ > 0.0 ? surface_->GetPointData()->GetArray(array_.c_str()) : nullptr;
  vtkDataArray* normals = surface_->GetPointData()->GetNormals();
  Spread spread(apart);
  for (vtkIdType i = 0; vectors && i < surface_->GetNumberOfPoints(); ++i) {
    const Eigen::Vector3d point(surface_->GetPoint(i)), vector(vectors->GetTuple3(i));
    const double length = vector.norm();
    if (!(length >= leastLength && length <= longest_) || !point.allFinite()) continue;
    if (!spread.take(point)) continue;
    const Eigen::Vector3d normal = normals ? Eigen::Vector3d(normals->GetTuple3(i)) : Eigen::Vector3d::Zero();
    arrows_.push_back({point, point + factor_ * vector, normal});
  }
  if (arrows_.size() > most) return choose(coarser * apart);
  layer_.setVisible(!arrows_.empty());
}

/// Before each picture, as the camera may have moved. Zooming thins them in steps, so that most stay where they are.
void DifferenceArrows::prepare() {
  if (arrows_.empty()) return;
  vtkCamera* lens = renderer_->GetActiveCamera();
  const double pixel = 2.0 * lens->GetDistance() * std::tan(lens->GetViewAngle() * M_PI / 360.0) / view_->height();
  double apart = least;
  while (apart < pixelsApart * pixel && apart < furthest) apart *= coarser;
  if (apart != apart_) choose(apart_ = apart);
  layer_.draw(arrows_, pixel, surface_);
  renderer_->ResetCameraClippingRange();
}

}  // namespace mien
