#include "FaceColoring.h"

#include <vtkAlgorithm.h>
#include <vtkPDEFaceFilter.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "BundledFile.h"
#include "ColorKey.h"
#include "Comparison.h"
#include "FaceModel.h"
#include "FaceOverlay.h"
#include "FaceView.h"
#include "RoundedUp.h"

namespace mien {

namespace {

constexpr double leastDifference = 0.1;  // mm: rounding is not stretched to fill the scale

QString skinChoice() {
  return FaceColoring::tr("Skin");
}

QString photographChoice() {
  return FaceColoring::tr("Photograph");
}

QString patchChoice() {
  return FaceColoring::tr("Patches");
}

const FaceArray& patches() {
  static const FaceArray array = {"PatchId", -1, true, {}};
  return array;
}

const FaceArray& difference() {
  static const FaceArray array = {"Distance", -1, false, FaceColoring::tr("Difference A\u2013B (mm)")};
  return array;
}

}  // namespace

FaceColoring::FaceColoring(FaceModel* model, FaceView* view, Comparison* comparison, QObject* parent)
    : QObject(parent), model_(model), view_(view), comparison_(comparison) {
  sides_.push_back(std::make_unique<Side>(view));
  connect(model_, &FaceModel::updated, this, &FaceColoring::follow);
  connect(model_, &FaceModel::stateChanged, this, &FaceColoring::changed);  // a photograph may have come or gone
  connect(view_, &FaceView::overlayChanged, this, &FaceColoring::followOverlay);
  connect(view_, &FaceView::scanChanged, this, &FaceColoring::keySkins);
  connect(comparison_, &Comparison::changed, this, &FaceColoring::followComparison);
  connect(comparison_, &Comparison::measured, this, [this] {
    if (kind_ != Kind::Difference) return;
    growRange();
    paint();
  });
  arrays_ = FaceArray::in(surface());
}

FaceColoring::~FaceColoring() = default;

std::vector<ColorKey*> FaceColoring::keys() const {
  std::vector<ColorKey*> all;
  for (const auto& side : sides_) all.push_back(side->key);
  return all;
}

FaceColoring::Side::Side(FaceView* shown) : view(shown), key(new ColorKey(shown)) {}

void FaceColoring::setOther(FaceView* view) {
  sides_.resize(1);
  sides_.push_back(std::make_unique<Side>(view));
  if (isNumbers() || kind_ == Kind::Patches)
    paint();
  else
    view->showSurface(comparison_->mesh());
}

vtkPolyData* FaceColoring::surface() const {
  return vtkPolyData::SafeDownCast(model_->pipeline().surface()->GetOutputDataObject(0));
}

/// What B shows without colours of a difference; nullptr: nothing is compared.
vtkPolyData* FaceColoring::other() const {
  if (comparison_->kind() == Comparison::Kind::None) return nullptr;
  if (comparison_->mesh()) return comparison_->mesh();
  return vtkPolyData::SafeDownCast(comparison_->other()->pipeline().surface()->GetOutputDataObject(0));
}

/// The surfaces that colours are for, A first.
std::vector<vtkPolyData*> FaceColoring::colored() const {
  if (kind_ != Kind::Difference) return {surface(), other()};
  return {comparison_->drawn(Comparison::Side::A), comparison_->drawn(Comparison::Side::B)};
}

QStringList FaceColoring::choices() const {
  QStringList all = {skinChoice(), photographChoice(), patchChoice()};
  if (comparison_->kind() != Comparison::Kind::None) all << difference().title;
  for (const FaceArray& array : FaceArray::onDemand()) all << array.title;
  for (const FaceArray& array : arrays_) all << array.title;
  return all;
}

QString FaceColoring::chosen() const {
  switch (kind_) {
    case Kind::Patches:
      return patchChoice();
    case Kind::Numbers:
    case Kind::Difference:
      return array_.title;
    case Kind::OfDock:
      return dock_;
    default:
      return model_->state().texture.empty() ? skinChoice() : photographChoice();
  }
}

/// Curvatures and derivatives are made for this alone.
std::string FaceColoring::arrayName() const {
  const bool whole = kind_ == Kind::Patches || (kind_ == Kind::Numbers && array_.component < 0 &&
                                                !array_.isDerivative() && !array_.isCurvature());
  return whole ? array_.name : std::string();
}

void FaceColoring::choose(const QString& choice) {
  if (choice == chosen()) return;
  std::vector<FaceArray> all = FaceArray::onDemand();
  all.insert(all.end(), arrays_.begin(), arrays_.end());
  const auto array = std::find_if(all.begin(), all.end(), [&](const FaceArray& one) { return one.title == choice; });
  if (choice == skinChoice() || choice == photographChoice()) {
    choosePhotograph(choice == photographChoice());
    view_->showOverlay(nullptr, true);
  } else if (choice == patchChoice()) {
    take(Kind::Patches, patches());
  } else if (choice == difference().title) {
    take(Kind::Difference, difference());
  } else if (array != all.end()) {
    take(Kind::Numbers, *array);
  }
}

void FaceColoring::take(Kind kind, const FaceArray& array) {
  kind_ = kind;
  array_ = array;
  setDock({});
  produce(array);
  begin_ = automatic_ ? 0.0 : begin_;
  end_ = automatic_ ? 0.0 : end_;
  growRange();
  paint();
}

/// The state says whether there is one; the last one comes back, and without any the one that comes with Mien.
void FaceColoring::choosePhotograph(bool on) {
  const FaceState& now = model_->state();
  if (on != now.texture.empty()) return;
  if (!on) {
    photograph_ = now.texture;
    photographMesh_ = now.textureMesh;
  }
  const bool painted = photograph_.empty();
  const std::string image = painted ? bundledFile("textures/painted.png").toStdString() : photograph_;
  const std::string mesh = painted ? bundledFile("textures/painted_7x7.csv").toStdString() : photographMesh_;
  model_->change([&](FaceState& state) {
    state.texture = on ? image : std::string();
    state.textureMesh = on ? mesh : std::string();
  });
}

/// Has the face filters compute what is asked for, and nothing that is not: curvatures double their time.
void FaceColoring::produce(const FaceArray& array) {
  std::vector<FaceModel*> faces = {model_};
  if (sides_.size() > 1) faces.push_back(comparison_->other());
  for (FaceModel* model : faces) {
    vtkPDEFaceFilter* face = model->pipeline().face();
    const bool changes =
        face->GetGenerateCurvatures() != array.isCurvature() || face->GetGenerateDerivatives() != array.isDerivative();
    face->SetGenerateCurvatures(array.isCurvature());
    face->SetGenerateDerivatives(array.isDerivative());
    if (changes) model->update();
  }
}

void FaceColoring::follow() {
  std::vector<FaceArray> now = FaceArray::in(surface());
  if (now != arrays_) {
    arrays_ = std::move(now);
    emit choicesChanged();
  }
  if (kind_ != Kind::Numbers) return;
  if (!array_.find(surface())) {
    emit model_->remarked(tr("%1 is known only of a face that no table bends; the skin is shown.").arg(array_.title),
                          QString());
    return view_->showOverlay(nullptr, true);
  }
  growRange();
  paint();
}

void FaceColoring::followOverlay(const QObject* overlay) {
  if (overlay == this) return;
  const bool shown = isNumbers() || kind_ == Kind::Patches;
  const auto* dock = qobject_cast<const FaceOverlay*>(overlay);
  kind_ = overlay ? Kind::OfDock : Kind::Skin;
  if (shown) clearColors();
  ColorKey* key = sides_.front()->key;
  dock && dock->scale() ? key->showScale(*dock->scale()) : key->clear();
  keySkins();
  if (sides_.size() > 1)
    dock && dock->scale() ? sides_[1]->key->showWords(tr("%1: of A alone").arg(dock->words()))
                          : sides_[1]->key->clear();
  setDock(dock ? dock->words() : QString());
  emit changed();
}

/// Without numbers on the face its key has room for the two skins.
void FaceColoring::keySkins() {
  if (kind_ != Kind::Skin) return;
  ColorKey* key = sides_.front()->key;
  view_->scan().isValid() ? key->showScan(view_->scan()) : key->clear();
}

void FaceColoring::setDock(const QString& words) {
  if (words == dock_) return;
  dock_ = words;
  emit choicesChanged();
}

void FaceColoring::clearColors() {
  for (const auto& side : sides_) {
    side->view->setColors({}, nullptr);
    side->view->showSurface(side == sides_.front() ? nullptr : comparison_->mesh());
    side->key->clear();
  }
  produce({});
}

/// What two faces are compared for is their difference; a choice that is left stays for the next B.
void FaceColoring::followComparison() {
  const bool compares = comparison_->kind() != Comparison::Kind::None, begins = compares && !compares_;
  compares_ = compares;
  emit choicesChanged();
  if (begins && kind_ != Kind::Difference) return take(Kind::Difference, difference());
  if (!compares && kind_ == Kind::Difference) return view_->showOverlay(nullptr, true);
  if (isNumbers() || kind_ == Kind::Patches)
    take(kind_, array_);
  else if (sides_.size() > 1)
    sides_[1]->view->showSurface(comparison_->mesh());
}

void FaceColoring::setAutomatic(bool automatic) {
  automatic_ = automatic;
  if (automatic) fit();
}

void FaceColoring::fit() {
  if (!isNumbers()) return;
  begin_ = end_ = 0.0;
  growRange();
  paint();
}

void FaceColoring::fitNext() {
  fitsNext_ = true;
}

void FaceColoring::setRange(double begin, double end) {
  if (!(begin < end)) return;
  automatic_ = false;
  begin_ = begin;
  end_ = end;
  if (isNumbers()) paint();
}

/// A scan has a neck that no face reaches: the range of a difference is that of A. Values of both signs get a range
/// that is symmetric about 0, others begin at 0.
void FaceColoring::growRange() {
  if (!automatic_) {
    if (!(begin_ < end_)) end_ = begin_ + 1.0;
    return;
  }
  if (std::exchange(fitsNext_, false)) begin_ = end_ = 0.0;
  for (vtkPolyData* shown : colored()) {
    if (!array_.find(shown) || (kind_ == Kind::Difference && shown != colored().front())) continue;
    const auto [low, high] = array_.spread(shown);
    const double most = std::max(high, -low);
    end_ = std::max(end_, roundedUp(kind_ == Kind::Difference ? std::max(most, leastDifference)
                                    : most > 0.0              ? most
                                                              : 1.0));
    if (low < 0.0 || begin_ < 0.0) begin_ = -end_;
  }
}

void FaceColoring::paint() {
  view_->showOverlay(this, true);
  for (size_t side = 0; side < sides_.size(); ++side) paintSide(side);
  emit changed();
}

/// Both sides have one, and tell the same of it.
ColorLegend::Scale FaceColoring::scale() const {
  const bool mixed = begin_ < 0.0 && end_ > 0.0;
  ColorLegend::Scale scale = {array_.title, begin_, end_,
                              mixed ? ColorLegend::Colors::Diverging : ColorLegend::Colors::Sequential};
  for (vtkPolyData* one : colored()) {
    if (!array_.find(one)) continue;
    const auto [low, high] = array_.range(one);
    const double ends[] = {low, high};
    scale.mark(ends);
  }
  if (kind_ == Kind::Difference && comparison_->leavesOut()) scale.unknown = tr("not compared");
  return scale;
}

/// A mesh has no patches and not every array: it keeps its skin, and the place of the key, so that both are of one
/// height.
void FaceColoring::paintSide(size_t side) {
  auto& [view, key, legend] = *sides_[side];
  vtkPolyData* shown = colored()[side];
  vtkPolyData* mesh = side == 0 ? nullptr : comparison_->mesh();
  const bool isPatches = kind_ == Kind::Patches;
  const ColorLegend::Scale scale = this->scale();
  isPatches ? legend.setPatches() : legend.setScale(scale);
  view->showSurface(kind_ == Kind::Difference && shown ? shown : mesh, mesh != nullptr);
  const bool has = array_.find(shown) != nullptr;
  view->setColors(array_, has ? &legend : nullptr);
  if (!has) return key->showWords(isPatches ? tr("B has no patches") : tr("B has no %1").arg(array_.title));
  isPatches ? key->showPatches() : key->showScale(scale);
}

}  // namespace mien
