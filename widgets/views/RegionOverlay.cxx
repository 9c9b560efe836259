#include "RegionOverlay.h"

#include <vtkBillboardTextActor3D.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkFDTDeformationFilter.h>
#include <vtkFDTReader.h>
#include <vtkFacialRegionFilter.h>
#include <vtkGeometryFilter.h>
#include <vtkPDEFaceFilter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkReverseSense.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <QEvent>
#include <algorithm>
#include <cmath>

#include "FaceModel.h"
#include "FaceOverlay.h"
#include "FaceView.h"
#include "SurfaceParameters.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int fineRows = 218, fineColumns = 160;  // borders of regions are then finer than a number's line
constexpr const char* colorArray = "RegionColor";
constexpr double lift = 8.0;  // mm from the skin to the camera, or a number's corners would sink into a cheek
constexpr double sizeShare = 1.0 / 32.0;  // of the view's height
constexpr int leastSize = 14;             // pt
constexpr double emphasis = 1.4;          // of the number of the region that stands out
constexpr double leastTowards = 0.3;      // cosine between skin and the way to the camera, for a number's place
constexpr double coverDepth = 12.0, coverReach = 5.0;  // mm: skin that hides a place, in front of it and aside
constexpr double paleness = 0.75;                      // of regions that do not stand out

// Of region 1 .. 16; neighbours differ, mirrored regions are alike where they do not touch. After Okabe and Ito,
// lighter.
const QColor regionColors[] = {"#7cc3ea", "#d59abd", "#f2e470", "#6fc3a4", "#6fc3a4", "#d59abd", "#d59abd", "#7cc3ea",
                               "#f2e470", "#efb65a", "#efb65a", "#d59abd", "#f2e470", "#6fc3a4", "#6fc3a4", "#7cc3ea"};

QColor mixed(const QColor& a, const QColor& b, double share) {
  return QColor::fromRgbF(a.redF() + share * (b.redF() - a.redF()), a.greenF() + share * (b.greenF() - a.greenF()),
                          a.blueF() + share * (b.blueF() - a.blueF()));
}

/// The points of a skin that has been through vtkFacialRegionFilter, as they are seen from somewhere.
struct RegionPoints {
  vtkPolyData* skin;
  Eigen::Vector3d towards;  ///< from the skin to the camera
  vtkDataArray *regions, *coverage, *normals;

  explicit RegionPoints(vtkPolyData* data, const Eigen::Vector3d& eye = Eigen::Vector3d::UnitZ())
      : skin(data),
        towards((eye - Eigen::Vector3d(data->GetCenter())).normalized()),
        regions(data->GetPointData()->GetArray("Region")),
        coverage(data->GetPointData()->GetArray("RegionCoverage")),
        normals(data->GetPointData()->GetArray("Normals")) {}

  int region(vtkIdType point) const { return static_cast<int>(regions->GetComponent(point, 0)); }
  double share(vtkIdType point) const { return coverage->GetComponent(point, 0); }

  /// How much a point looks at the camera: most points of a cheek are at the side of the head, where no number is read
  /// from the front.
  double weight(vtkIdType point) const {
    const double seen = normals ? towards.dot(Eigen::Vector3d(normals->GetTuple3(point))) : 1.0;
    return seen < leastTowards ? 0.0 : share(point) * seen * seen * seen;
  }

  /// Whether there is a place for its number: on the face and turned to the camera.
  bool bearsNumber(vtkIdType point) const { return weight(point) > 0.25; }

  /// For each region the point nearest to the middle of what is seen of it; -1 where nothing is.
  std::array<vtkIdType, 16> middles() const {
    std::array<Eigen::Vector3d, 16> middle;
    std::array<double, 16> weights{}, least;
    std::array<vtkIdType, 16> nearest;
    middle.fill(Eigen::Vector3d::Zero());
    least.fill(1e300);
    nearest.fill(-1);
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
      middle[region(i) - 1] += weight(i) * place(i);
      weights[region(i) - 1] += weight(i);
    }
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
      const int index = region(i) - 1;
      if (!bearsNumber(i)) continue;
      // As it is seen: the middle of a nose's points lies within the nose.
      const double distance = (place(i) - middle[index] / weights[index]).cross(towards).norm();
      if (distance >= least[index]) continue;
      least[index] = distance;
      nearest[index] = i;
    }
    leaveOutHidden(nearest);
    return nearest;
  }

  /// Takes out points with skin between them and the camera, as a cheek behind the nose.
  void leaveOutHidden(std::array<vtkIdType, 16>& points) const {
    const std::array<vtkIdType, 16> asked = points;
    std::array<Eigen::Vector3d, 16> places;
    for (int k = 0; k < 16; ++k) places[k] = asked[k] < 0 ? Eigen::Vector3d::Zero() : place(asked[k]);
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
      const Eigen::Vector3d other = place(i);
      for (int k = 0; k < 16; ++k) {
        const Eigen::Vector3d way = other - places[k];
        const double nearer = way.dot(towards);
        if (nearer > coverDepth && way.squaredNorm() - nearer * nearer < coverReach * coverReach) points[k] = -1;
      }
    }
  }

  Eigen::Vector3d place(vtkIdType point) const { return Eigen::Vector3d(skin->GetPoint(point)); }
};

}  // namespace

RegionOverlay::RegionOverlay(FaceModel* model, FaceView* view, QObject* parent)
    : QObject(parent),
      model_(model),
      view_(view),
      renderer_(view->renderer()),
      overlay_(new FaceOverlay(view, tr("Deformation"), this)) {
  fine_->SetResolution(fineRows, fineColumns);
  regions_->SetInputConnection(fine_->GetOutputPort());
  deformation_->SetInputConnection(regions_->GetOutputPort());
  deformation_->SetTableConnection(table_->GetOutputPort());
  outwards_->SetInputConnection(geometry_->GetOutputPort());
  for (vtkAlgorithm* algorithm :
       std::initializer_list<vtkAlgorithm*>{fine_, regions_, table_, deformation_, geometry_, outwards_})
    errors_.observe(algorithm);
  for (size_t i = 0; i < numbers_.size(); ++i) {
    numbers_[i]->SetInput(std::to_string(i + 1).c_str());
    vtkTextProperty* text = numbers_[i]->GetTextProperty();
    text->SetJustificationToCentered();
    text->SetVerticalJustificationToCentered();
    text->SetColor(0.06, 0.08, 0.1);
    text->SetBold(true);
  }
  started_ = view_->renderer()->AddObserver(vtkCommand::StartEvent, this, &RegionOverlay::turnNumbers);
  view_->installEventFilter(this);
  overlay_->setSubject(tr("Regions"));
  connect(overlay_, &FaceOverlay::shownChanged, this, [this](bool shown) {
    if (!shown) removeNumbers();
    emit shownChanged(shown);
  });
}

RegionOverlay::~RegionOverlay() {
  renderer_->RemoveObserver(started_);
}

bool RegionOverlay::isShown() const {
  return overlay_->isShown();
}

void RegionOverlay::hide() {
  overlay_->hide();
}

/// The regions are those of the face before a table, as the deformation takes them.
std::string RegionOverlay::build() {
  const FaceDeformation& chosen = model_->state().deformation;
  vtkNew<vtkPolyData> curves;
  curves->ShallowCopy(model_->pipeline().curves()->GetOutputDataObject(0));
  errors_.clear();
  fine_->SetInputData(curves);
  setParameters(model_->state().surface, fine_);
  table_->SetFileName(chosen.table.empty() ? nullptr : chosen.table.c_str());
  deformation_->SetStrength(chosen.strength);
  deformation_->SetSmooth(chosen.smooth);
  vtkAlgorithm* skin = regions_;
  if (!chosen.table.empty()) skin = deformation_;
  geometry_->SetInputConnection(skin->GetOutputPort());
  outwards_->Update();
  return errors_.first();
}

void RegionOverlay::show() {
  const std::string fault = build();
  if (fault.empty()) return paint();
  hide();
  emit model_->failed(QString::fromStdString(fault), tr("The regions cannot be shown."));
}

void RegionOverlay::emphasise(int region) {
  if (region == region_) return;
  region_ = region;
  if (isShown()) paint();
}

void RegionOverlay::paint() {
  vtkNew<vtkPolyData> skin;
  skin->ShallowCopy(outwards_->GetOutput());
  color(skin);
  overlay_->showColors(skin, colorArray);
  skin_ = skin;
  eye_.reset();
  for (const auto& number : numbers_) view_->renderer()->AddActor(number);
  view_->redraw();
}

void RegionOverlay::color(vtkPolyData* skin) const {
  std::array<QColor, 16> shown;
  const QColor plain = Theme::current().skin;
  for (int i = 0; i < 16; ++i)
    shown[i] = mixed(regionColors[i], plain, region_ == 0 || region_ == i + 1 ? 0.0 : paleness);
  const RegionPoints points(skin);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName(colorArray);
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(skin->GetNumberOfPoints());
  for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) {
    const QColor color = mixed(plain, shown[points.region(i) - 1], points.share(i));
    const int channels[] = {color.red(), color.green(), color.blue()};
    for (int channel = 0; channel < 3; ++channel) colors->SetComponent(i, channel, channels[channel]);
  }
  skin->GetPointData()->AddArray(colors);
}

/// Every number stands between its skin and the camera, so that it is seen where its region is, from any side.
void RegionOverlay::placeNumbers(const Eigen::Vector3d& eye) {
  const RegionPoints points(skin_, eye);
  const std::array<vtkIdType, 16> middles = points.middles();
  for (int i = 0; i < 16; ++i) {
    numbers_[i]->SetVisibility(middles[i] >= 0);
    if (middles[i] < 0) continue;
    const Eigen::Vector3d place = points.place(middles[i]), before = place + lift * (eye - place).normalized();
    numbers_[i]->SetPosition(before.x(), before.y(), before.z());
  }
  eye_ = eye;
}

/// Before each picture.
void RegionOverlay::turnNumbers() {
  if (!isShown()) return;
  const Eigen::Vector3d eye(renderer_->GetActiveCamera()->GetPosition());
  if (eye_ != eye) placeNumbers(eye);
  const double size = std::max<double>(leastSize, sizeShare * renderer_->GetSize()[1]);
  for (int i = 0; i < 16; ++i)
    numbers_[i]->GetTextProperty()->SetFontSize(std::lround(region_ == i + 1 ? emphasis * size : size));
}

void RegionOverlay::removeNumbers() {
  skin_ = nullptr;
  for (const auto& number : numbers_) view_->renderer()->RemoveActor(number);
}

bool RegionOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange && isShown()) paint();
  return QObject::eventFilter(watched, event);
}

}  // namespace mien
