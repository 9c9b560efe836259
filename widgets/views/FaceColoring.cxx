#include "FaceColoring.h"

#include <vtkAlgorithm.h>
#include <vtkPDEFaceFilter.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

#include "BundledFile.h"
#include "ColorKey.h"
#include "FaceModel.h"
#include "FaceView.h"
#include "RoundedUp.h"

namespace mien {

namespace {

QString skinChoice() {
  return FaceColoring::tr("Skin");
}

QString photographChoice() {
  return FaceColoring::tr("Photograph");
}

QString patchChoice() {
  return FaceColoring::tr("Patches");
}

}  // namespace

FaceColoring::FaceColoring(FaceModel* model, FaceView* view, QObject* parent)
    : QObject(parent), model_(model), view_(view), key_(new ColorKey(view)) {
  connect(model_, &FaceModel::updated, this, &FaceColoring::follow);
  connect(model_, &FaceModel::stateChanged, this, &FaceColoring::changed);  // a photograph may have come or gone
  connect(view_, &FaceView::overlayChanged, this, &FaceColoring::followOverlay);
  arrays_ = FaceArray::in(surface());
}

FaceColoring::~FaceColoring() = default;

vtkPolyData* FaceColoring::surface() const {
  return vtkPolyData::SafeDownCast(model_->pipeline().surface()->GetOutputDataObject(0));
}

QStringList FaceColoring::choices() const {
  QStringList all = {skinChoice(), photographChoice(), patchChoice()};
  for (const FaceArray& array : FaceArray::onDemand()) all << array.title;
  for (const FaceArray& array : arrays_) all << array.title;
  return all;
}

QString FaceColoring::chosen() const {
  switch (kind_) {
    case Kind::Patches:
      return patchChoice();
    case Kind::Numbers:
      return array_.title;
    case Kind::OfDock:
      return {};
    default:
      return model_->state().texture.empty() ? skinChoice() : photographChoice();
  }
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
    kind_ = Kind::Patches;
    produce({});
    paint();
  } else if (array != all.end()) {
    kind_ = Kind::Numbers;
    array_ = *array;
    produce(array_);
    begin_ = end_ = 0.0;
    growRange();
    paint();
  }
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

/// Has the face filter compute what is asked for, and nothing that is not: curvatures double its time.
void FaceColoring::produce(const FaceArray& array) {
  vtkPDEFaceFilter* face = model_->pipeline().face();
  const bool changes =
      face->GetGenerateCurvatures() != array.isCurvature() || face->GetGenerateDerivatives() != array.isDerivative();
  face->SetGenerateCurvatures(array.isCurvature());
  face->SetGenerateDerivatives(array.isDerivative());
  if (changes) model_->update();
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
  const bool shown = kind_ == Kind::Patches || kind_ == Kind::Numbers;
  kind_ = overlay ? Kind::OfDock : Kind::Skin;
  if (shown) {
    view_->setColors({}, nullptr);
    key_->clear();
    produce({});
  }
  emit changed();
}

void FaceColoring::setAutomatic(bool automatic) {
  automatic_ = automatic;
  if (automatic) fit();
}

void FaceColoring::fit() {
  if (kind_ != Kind::Numbers) return;
  begin_ = end_ = 0.0;
  growRange();
  paint();
}

void FaceColoring::setRange(double begin, double end) {
  if (!(begin < end)) return;
  automatic_ = false;
  begin_ = begin;
  end_ = end;
  if (kind_ == Kind::Numbers) paint();
}

/// Values of both signs get a range that is symmetric about 0, others begin at 0.
void FaceColoring::growRange() {
  if (!automatic_) {
    if (!(begin_ < end_)) end_ = begin_ + 1.0;
    return;
  }
  const auto [low, high] = array_.spread(surface());
  if (low < 0.0 || begin_ < 0.0) {
    end_ = std::max(end_, roundedUp(std::max(-low, high)));
    begin_ = -end_;
  } else {
    end_ = std::max(end_, roundedUp(high));
  }
}

void FaceColoring::paint() {
  const bool patches = kind_ == Kind::Patches, mixed = begin_ < 0.0 && end_ > 0.0;
  const ColorLegend::Scale scale = {array_.title, begin_, end_,
                                    mixed ? ColorLegend::Colors::Diverging : ColorLegend::Colors::Sequential};
  patches ? legend_.setPatches() : legend_.setScale(scale);
  patches ? key_->showPatches() : key_->showScale(scale);
  static const FaceArray patchArray = {"PatchId", -1, true, {}};
  view_->showOverlay(this, true);
  view_->setColors(patches ? patchArray : array_, &legend_);
  emit changed();
}

}  // namespace mien
