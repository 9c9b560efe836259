#include "VectorControls.h"

#include <vtkCamera.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVariant>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "ColorTable.h"
#include "MotionVectorFigure.h"
#include "RenderView.h"
#include "SignedBox.h"

namespace mien {

namespace {

using Length = MotionVectorOptions::Length;
using Color = MotionVectorOptions::Color;

constexpr int bySize = 0, evenly = 1;                                    // of samplings
constexpr int automatic = 0, trueToFace = 1, given = 2;                  // of scales
constexpr int givenRange = 1;                                            // of ranges
constexpr double leastSpacing = 1.0, mostSpacing = 50.0, spacing = 5.0;  // mm
constexpr double mostStep = 50.0;                                        // of vertices
constexpr double leastScale = 0.01, mostScale = 1000.0;                  // mm of motion per mm of arrow
constexpr double leastRange = 0.01, mostRange = 1000.0;                  // mm
constexpr VectorSampling::Kind samplings[] = {VectorSampling::Kind::Automatic, VectorSampling::Kind::Even,
                                              VectorSampling::Kind::Every};
const double diagonal = std::sqrt(0.5);

struct View {
  const char* name;
  Eigen::Vector3d direction;
};

const std::vector<View>& views() {
  static const std::vector<View> all = {
      {QT_TRANSLATE_NOOP("VectorControls", "Front"), {0.0, 0.0, 1.0}},
      {QT_TRANSLATE_NOOP("VectorControls", "45\u00b0"), {diagonal, 0.0, diagonal}},
      {QT_TRANSLATE_NOOP("VectorControls", "Side"), {1.0, 0.0, 0.0}},
      {QT_TRANSLATE_NOOP("VectorControls", "Other 45\u00b0"), {-diagonal, 0.0, diagonal}},
      {QT_TRANSLATE_NOOP("VectorControls", "Other side"), {-1.0, 0.0, 0.0}},
      {QT_TRANSLATE_NOOP("VectorControls", "Top"), {0.0, 1.0, 0.0}}};
  return all;
}

QStringList mapNames() {
  QStringList names = {VectorControls::tr("Automatic")};
  for (const ColorTable& table : ColorTable::all()) names << QString::fromStdString(table.name);
  return names;
}

}  // namespace

VectorControls::VectorControls(RenderView* view, QWidget* parent)
    : QWidget(parent), other_(view), grid_(new QGridLayout(this)) {
  setObjectName("vectorControls");
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setVerticalSpacing(1);
  grid_->setHorizontalSpacing(6);
  buildPicture();
  buildArrows();
  grid_->setColumnStretch(1, 1);
  connectAll();
  followChoices();
}

QComboBox* VectorControls::list(const char* name, const QStringList& entries, const QString& tip) {
  auto* made = new QComboBox(this);
  made->setObjectName(name);
  made->addItems(entries);
  made->setToolTip(tip);
  made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  made->setMinimumContentsLength(7);
  return made;
}

QDoubleSpinBox* VectorControls::number(const char* name, double least, double most, double value, const QString& unit,
                                       const QString& tip) {
  auto* made = new SignedNumberBox(this);
  made->setObjectName(name);
  made->setRange(least, most);
  made->setValue(value);
  made->setSuffix(unit);
  made->setToolTip(tip);
  made->setKeyboardTracking(false);
  made->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  made->setButtonSymbols(QAbstractSpinBox::NoButtons);
  made->setFixedWidth(made->fontMetrics().horizontalAdvance("1000.00 mm/mm"));
  return made;
}

QCheckBox* VectorControls::check(const char* name, const QString& text, const QString& tip) {
  auto* made = new QCheckBox(text, this);
  made->setObjectName(name);
  made->setToolTip(tip);
  connect(made, &QCheckBox::toggled, this, &VectorControls::changed);
  return made;
}

void VectorControls::add(const QString& name, QWidget* first, QWidget* second) {
  auto* label = new QLabel(name, this);
  label->setBuddy(first);
  label->setToolTip(first->toolTip());
  first->setAccessibleName(name);
  if (second) second->setAccessibleName(tr("%1, value").arg(name));
  grid_->addWidget(label, count_, 0);
  grid_->addWidget(first, count_, 1, 1, second ? 1 : 2);
  if (second) grid_->addWidget(second, count_, 2);
  ++count_;
}

void VectorControls::buildPicture() {
  QStringList names;
  for (const View& view : views()) names << tr(view.name);
  view_ = list("vectorsView", names << tr("As the face"),
               tr("From where the vectors are seen, in orthogonal projection; As the face: from "
                  "where the three-dimensional view shows the face"));
  QStringList regions = {tr("Whole face")};
  for (const QString& region : QString::fromStdString(VectorRegion::names()).split(", "))
    regions << region.left(1).toUpper() + region.mid(1);
  for (int patch = 0; patch < 9; ++patch) regions << QString("P%1").arg(patch);
  region_ = list("vectorsRegion", regions,
                 tr("Part of the face; or drag a rectangle in the figure, double click for the whole face"));
  add(tr("View"), view_);
  add(tr("Region"), region_);
  sampling_ =
      list("vectorsSampling", {tr("Automatic"), tr("Evenly"), tr("Every n-th")},
           tr("Which of the vectors are drawn: as close as the figure's size lets arrows be told apart, evenly at that "
              "distance in the picture, or every n-th vertex of the mesh"));
  spacing_ =
      number("vectorsSpacing", leastSpacing, mostSpacing, spacing, tr(" mm"), tr("Distance between vectors, or n"));
  add(tr("Sampling"), sampling_, spacing_);
}

void VectorControls::buildArrows() {
  length_ = list("vectorsLength", {tr("As seen"), tr("In space"), tr("Equal")},
                 tr("Length of the arrows: the vector as the view shows it, its length in space, or equal, which shows "
                    "directions"));
  scale_ = list("vectorsScale", {tr("Automatic"), tr("As the face"), tr("Given")},
                tr("Scale of the arrows: a round one for the whole of an open animation, without one for what is seen, "
                   "growing at once and shrinking after two seconds of less; as large as the face is drawn; or given"));
  scaleValue_ =
      number("vectorsScaleValue", leastScale, mostScale, 1.0, tr(" mm/mm"), tr("mm of motion in one mm of arrow"));
  color_ = list("vectorsColor", {tr("Length"), tr("Towards viewer"), tr("None")},
                tr("What the colours tell: length in space, the component towards the viewer, or nothing; in mm"));
  map_ = list("vectorsColorMap", mapNames(),
              tr("Colour map: viridis for lengths and coolwarm, which diverges from zero, towards the viewer; or one "
                 "of your choice"));
  range_ =
      list("vectorsRange", {tr("Automatic"), tr("Up to")},
           tr("Range of the colours: one for the whole of an open animation, without one for what is seen, growing "
              "at once and shrinking after two seconds of less; or up to a given length"));
  rangeValue_ = number("vectorsRangeValue", leastRange, mostRange, 10.0, tr(" mm"), tr("End of the colours, mm"));
  head_ =
      check("vectorsHead", tr("Without the head's rotation"), tr("Leave out the rotation of the head (FAP 48 to 50)"));
  whole_ = check("vectorsWhole", tr("Region within the whole face"),
                 tr("Show a region within the whole face, not enlarged"));
  seams_ = check("vectorsSeams", tr("Seams"), tr("The lines between the nine patches"));
  seams_->setChecked(true);
  add(tr("Arrows"), length_);
  add(tr("Scale"), scale_, scaleValue_);
  add(tr("Colours"), color_, map_);
  add(tr("Range"), range_, rangeValue_);
  auto* checks = new QHBoxLayout;
  for (QCheckBox* box : {whole_, seams_}) checks->addWidget(box);
  checks->addStretch();
  grid_->addWidget(head_, count_, 0, 1, 3);
  grid_->addLayout(checks, count_ + 1, 0, 1, 3);
}

void VectorControls::connectAll() {
  for (QComboBox* box : {view_, region_, sampling_, scale_, length_, color_, map_, range_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &VectorControls::followChoices);
  for (QDoubleSpinBox* box : {spacing_, scaleValue_, rangeValue_})
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &VectorControls::changed);
}

void VectorControls::followChoices() {
  showSpacing(sampling_->currentIndex() <= evenly);
  const std::pair<QDoubleSpinBox*, bool> values[] = {{spacing_, sampling_->currentIndex() != bySize},
                                                     {scaleValue_, scale_->currentIndex() == given},
                                                     {rangeValue_, range_->currentIndex() == givenRange}};
  for (const auto& [value, isGiven] : values) {
    value->setEnabled(isGiven);
    value->setProperty(notInSession, !isGiven);  // as it shows what is in effect
  }
  scale_->setEnabled(length_->currentIndex() != static_cast<int>(Length::Equal));
  map_->setEnabled(color_->currentIndex() != static_cast<int>(Color::None));
  emit scaleChanged();
  emit changed();
}

void VectorControls::showSpacing(bool isEven) {
  const QSignalBlocker quiet(spacing_);
  spacing_->setSuffix(isEven ? tr(" mm") : QString());
  spacing_->setPrefix(isEven ? QString() : tr("n = "));
  spacing_->setDecimals(isEven ? 1 : 0);
  spacing_->setMaximum(isEven ? mostSpacing : mostStep);
}

void VectorControls::showInEffect(const MotionVectorFigure& figure) {
  const QSignalBlocker quiet[] = {QSignalBlocker(spacing_), QSignalBlocker(scaleValue_), QSignalBlocker(rangeValue_)};
  const VectorSampling& sampling = figure.sampling();
  const bool isEven = sampling.kind == VectorSampling::Kind::Even;
  if (!spacing_->isEnabled()) {
    showSpacing(isEven);
    spacing_->setValue(isEven ? sampling.spacing : sampling.step);
  }
  const bool moves = figure.reference() > 0.0;
  if (!scaleValue_->isEnabled() && moves) scaleValue_->setValue(figure.scale());
  if (!rangeValue_->isEnabled() && moves && !figure.lacksTowards()) rangeValue_->setValue(figure.rangeEnd());
}

bool VectorControls::followsView() const {
  return view_->currentIndex() == static_cast<int>(views().size());
}

QString VectorControls::viewName() const {
  return view_->currentText().toLower();
}

bool VectorControls::headMotionRemoved() const {
  return head_->isChecked();
}

void VectorControls::look(PicturePlane& plane) const {
  if (followsView()) {
    double direction[3], up[3];
    other_->camera()->GetDirectionOfProjection(direction);
    other_->camera()->GetViewUp(up);
    plane.look(-Eigen::Vector3d(direction), Eigen::Vector3d(up));
    return;
  }
  const Eigen::Vector3d& direction = views()[view_->currentIndex()].direction;
  plane.look(direction, direction.y() > 0.5 ? Eigen::Vector3d(0.0, 0.0, -1.0) : Eigen::Vector3d::UnitY());
}

MotionVectorOptions VectorControls::options() const {
  MotionVectorOptions options;
  look(options.picture.plane);
  VectorSampling& sampling = options.picture.sampling;
  sampling.kind = samplings[sampling_->currentIndex()];
  if (sampling_->currentIndex() != bySize) {
    sampling.spacing = spacing_->value();
    sampling.step = static_cast<int>(std::lround(spacing_->value()));
  }
  options.picture.wholeFrame = whole_->isChecked();
  options.length = static_cast<Length>(length_->currentIndex());
  options.color = static_cast<Color>(color_->currentIndex());
  if (map_->currentIndex() > 0) options.colorMap = map_->currentText().toStdString();
  options.trueToFace = scale_->currentIndex() == trueToFace;
  if (scale_->currentIndex() == given) options.scale = scaleValue_->value();
  const double end = rangeValue_->value();
  if (range_->currentIndex() == givenRange) options.range = {options.color == Color::Towards ? -end : 0.0, end};
  options.seams = seams_->isChecked();
  return options;
}

std::string VectorControls::region() const {
  const QString text = region_->currentText();
  if (region_->currentData().isValid()) return region_->currentData().toString().toStdString();
  const bool isWord = text.size() > 2 && text[0].isLetter();
  if (region_->currentIndex() == 0) return {};
  return (isWord ? text.toLower() : text).toStdString();
}

void VectorControls::setRegion(const Eigen::AlignedBox2d& rectangle) {
  const auto text = [](double value) { return QString::number(value, 'f', 1); };
  const QString name = QStringList{text(rectangle.min().x()), text(rectangle.min().y()), text(rectangle.max().x()),
                                   text(rectangle.max().y())}
                           .join(',');
  {
    const QSignalBlocker quiet(region_);
    listDragged(name);
    region_->setCurrentIndex(-1);
  }
  region_->setCurrentText(tr("Dragged"));
}

void VectorControls::listDragged(const QString& name) {
  if (region_->findText(tr("Dragged")) < 0) region_->addItem(tr("Dragged"));
  const int row = region_->findText(tr("Dragged"));
  region_->setItemData(row, name);
  region_->setItemData(row, tr("%1 mm: left, lower, right and upper end").arg(name), Qt::ToolTipRole);
}

nlohmann::json VectorControls::sessionState() const {
  const int row = region_->findText(tr("Dragged"));
  if (row < 0) return nlohmann::json::object();
  return {{"dragged", region_->itemData(row).toString().toStdString()}};
}

void VectorControls::restoreSession(const nlohmann::json& state) {
  const int row = region_->findText(tr("Dragged"));
  const bool known = state.is_object() && state.contains("dragged") && state["dragged"].is_string();
  if (known)
    listDragged(QString::fromStdString(state["dragged"].get<std::string>()));
  else if (row >= 0)
    region_->removeItem(row);
  emit changed();
}

void VectorControls::setWholeRegion() {
  region_->setCurrentIndex(0);
}

}  // namespace mien
