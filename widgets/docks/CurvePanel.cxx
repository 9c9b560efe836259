#include "CurvePanel.h"

#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "CurveFile.h"
#include "FaceLayout.h"
#include "FaceModel.h"
#include "FileDialog.h"
#include "FramedButton.h"
#include "OverflowRow.h"
#include "ScanPanel.h"
#include "SessionPart.h"
#include "SignedBox.h"

namespace mien {

namespace {

constexpr int middle = FaceLayout::curveCount / 2;

QString textOf(const CurveEdit& edit) {
  const auto number = [](double millimetres) { return withRealMinus(QString::number(millimetres, 'f', 1)); };
  return CurvePanel::tr("%1, v %2\u00b0: (%3, %4, %5) mm, width %6\u00b0, spread %7%8")
      .arg(QString::fromStdString(FaceLayout::curveName(edit.curve)))
      .arg(edit.vDegrees(), 0, 'f', 1)
      .arg(number(edit.move.x()))
      .arg(number(edit.move.y()))
      .arg(number(edit.move.z()))
      .arg(edit.widthDegrees(), 0, 'f', 0)
      .arg(edit.spread)
      .arg(edit.mirrored ? CurvePanel::tr(", mirrored") : QString());
}

/// The neutral curves with the edits of this state and nothing else. @return nothing, or what is wrong
std::string writeCurves(const FaceState& state, const std::string& file) {
  FacePipeline pipeline;
  FaceState neutral;
  neutral.curvesFile = state.curvesFile;
  neutral.edits = state.edits;
  pipeline.setState(neutral);
  const std::string fault = pipeline.updateCurves();
  if (!fault.empty()) return fault;
  return writeCurveFile(vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0)), file);
}

}  // namespace

CurvePanel::CurvePanel(FaceModel* model, FaceView* face, CurveView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      handle_(new CurveHandle(view, model, this)),
      tabs_(new QTabWidget(this)),
      scan_(new ScanPanel(model, face, this)),
      curve_(new QComboBox(this)),
      point_(new SignedWholeBox(this)),
      spread_(new SignedWholeBox(this)),
      dx_(new SignedNumberBox(this)),
      dy_(new SignedNumberBox(this)),
      dz_(new SignedNumberBox(this)),
      width_(new SignedNumberBox(this)),
      mirror_(new QCheckBox(tr("Mirror"), this)),
      edits_(new QListWidget(this)),
      hint_(new QLabel(edits_->viewport())),
      apply_(new QToolButton(this)),
      drag_(new QToolButton(this)),
      undo_(new QToolButton(this)),
      remove_(new QToolButton(this)),
      clear_(new QToolButton(this)),
      save_(new QToolButton(this)) {
  setObjectName("curvePanel");
  describePlace();
  describeMove();
  describeButtons();
  setAcceptDrops(true);
  describeTabs();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 0, 8, 6);
  column->addWidget(tabs_);
  connectControls();
  connectHandle();
  showEdits();
}

void CurvePanel::describeTabs() {
  auto* moves = new QWidget(this);
  auto* column = new QVBoxLayout(moves);
  column->setContentsMargins(0, 6, 0, 0);
  column->setSpacing(4);
  column->addWidget(placeRow());
  column->addWidget(moveRow());
  column->addWidget(listColumn(), 1);
  tabs_->setObjectName("curveTabs");
  tabs_->addTab(moves, tr("Edit"));
  tabs_->addTab(scan_, tr("Scan"));
  tabs_->setTabToolTip(0, tr("Points of the curves are moved by hand"));
  tabs_->setTabToolTip(1, tr("The curves of a scan of a head, and its distance from the face"));
  giveRoom();
}

/// A page that is not shown takes none: a long report of a scan does not make the other page scroll.
void CurvePanel::giveRoom() {
  for (int i = 0; i < tabs_->count(); ++i) {
    const bool isShown = i == tabs_->currentIndex();
    tabs_->widget(i)->setSizePolicy(isShown ? QSizePolicy::Preferred : QSizePolicy::Ignored,
                                    isShown ? QSizePolicy::Preferred : QSizePolicy::Ignored);
    tabs_->widget(i)->updateGeometry();
  }
}

void CurvePanel::describePlace() {
  for (int i = 0; i < FaceLayout::curveCount; ++i) curve_->addItem(QString::fromStdString(FaceLayout::curveName(i)));
  curve_->setCurrentIndex(middle);
  curve_->setObjectName("curveCurve");
  curve_->setAccessibleName(tr("Curve"));
  curve_->setToolTip(tr("The curve of the point, from C1 at the forehead to C28 at the chin"));
  point_->setObjectName("curvePoint");
  point_->setAccessibleName(tr("Point"));
  point_->setToolTip(
      tr("The point of the curve, from 0; in the middle of the face is half of their number, more is the "
         "subject's left"));
  width_->setObjectName("curveWidth");
  width_->setAccessibleName(tr("Width"));
  width_->setRange(1.0, 180.0);
  width_->setValue(CurveEdit().widthDegrees());
  width_->setDecimals(1);
  width_->setSuffix("\u00b0");
  width_->setToolTip(tr("Where along the curve the fall-off ends, degrees of v on either side of the point"));
  spread_->setObjectName("curveSpread");
  spread_->setAccessibleName(tr("Spread"));
  spread_->setRange(0, CurveEdit::largestSpread);
  spread_->setValue(CurveEdit().spread);
  spread_->setToolTip(tr("How many neighbouring curves follow on either side"));
}

void CurvePanel::describeMove() {
  const auto describe = [](QDoubleSpinBox* box, const QString& name, const QString& label, const QString& tip) {
    box->setObjectName(name);
    box->setAccessibleName(label);
    box->setRange(-CurveEdit::largestMove, CurveEdit::largestMove);
    box->setDecimals(2);
    box->setSingleStep(0.5);
    box->setSuffix(" mm");
    box->setToolTip(tip);
  };
  describe(dx_, "curveDx", tr("Move to the left"), tr("How far the point moves towards the subject's left"));
  describe(dy_, "curveDy", tr("Move up"), tr("How far the point moves up"));
  describe(dz_, "curveDz", tr("Move forward"), tr("How far the point moves forward"));
  mirror_->setObjectName("curveMirror");
  mirror_->setChecked(true);
  mirror_->setToolTip(tr("The other side of the face moves as the mirror image"));
}

void CurvePanel::describeButtons() {
  makeFramed(apply_, "curveApply", tr("Move"), tr("Moves the point; what would make curves cross is refused"));
  makeFramed(drag_, "curveDrag", tr("Edit in the view"),
             tr("Points of the curves are dragged with the mouse in the curve view, in its plane, with this width, "
                "spread and mirror; Escape cancels a drag"));
  drag_->setCheckable(true);
  drag_->setProperty(notInSession, true);  // a mode of the mouse
  makeFramed(undo_, "curveUndo", tr("Undo"), tr("Takes the last move back"));
  makeFramed(remove_, "curveRemove", tr("Remove"), tr("Takes the chosen move out of the list"));
  makeFramed(clear_, "curveClear", tr("Remove all"), tr("The curves as they were read"));
  makeFramed(save_, "curveSave", tr("Save curves..."),
             tr("Writes the neutral curves with these moves as .vtp, which --face takes"));
  edits_->setObjectName("curveEdits");
  edits_->setToolTip(tr("The moves, made one after the other"));
  hint_->setObjectName("curveHint");
  hint_->setText(
      tr("No moves yet. Choose a curve and a point, give millimetres and press Move; or press Edit in the "
         "view and drag points there."));
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setProperty("faint", true);
  (new QVBoxLayout(edits_->viewport()))->addWidget(hint_);
}

QWidget* CurvePanel::placeRow() {
  return rowOf({{tr("Curve"), curve_},
                {tr("Point"), point_},
                {tr("Width"), width_},
                {tr("Spread"), spread_},
                {QString(), mirror_}});
}

QWidget* CurvePanel::moveRow() {
  auto* row = new OverflowRow("curveMoves", this);
  row->addLabelled(tr("Left"), dx_);
  row->addLabelled(tr("Up"), dy_);
  row->addLabelled(tr("Forward"), dz_);
  row->addWidget(apply_);
  row->addWidget(drag_, 1);  // the first that a narrow window has no room for
  row->addStretch();
  return row;
}

QWidget* CurvePanel::rowOf(const std::vector<std::pair<QString, QWidget*>>& controls) {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  for (const auto& [label, control] : controls) {
    if (!label.isEmpty()) row->addWidget(new QLabel(label, box));
    row->addWidget(control);
    row->addSpacing(6);
  }
  row->addStretch();
  return box;
}

QWidget* CurvePanel::listColumn() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(edits_, 1);
  auto* buttons = new QVBoxLayout;
  for (QToolButton* button : {undo_, remove_, clear_, save_}) {
    button->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    buttons->addWidget(button);
  }
  buttons->addStretch();
  row->addLayout(buttons);
  return box;
}

void CurvePanel::connectControls() {
  connect(apply_, &QToolButton::clicked, this, &CurvePanel::apply);
  connect(undo_, &QToolButton::clicked, this, [this] { remove(edits_->count() - 1); });
  connect(remove_, &QToolButton::clicked, this, [this] { remove(edits_->currentRow()); });
  connect(clear_, &QToolButton::clicked, this, [this] {
    model_->change([](FaceState& state) { state.edits.clear(); });
    model_->update();
  });
  connect(save_, &QToolButton::clicked, this, &CurvePanel::chooseSaved);
  connect(edits_, &QListWidget::currentRowChanged, remove_, [this](int row) { remove_->setEnabled(row >= 0); });
  connect(model_, &FaceModel::stateChanged, this, &CurvePanel::showEdits);
  connect(scan_, &ScanPanel::opened, this, [this] { tabs_->setCurrentWidget(scan_); });
  connect(tabs_, &QTabWidget::currentChanged, this, [this] {
    drag_->setChecked(false);
    giveRoom();
  });
  connect(model_, &FaceModel::updated, this, [this] { point_->setMaximum(model_->pointsPerCurve() - 1); });
  point_->setMaximum(model_->pointsPerCurve() - 1);
  point_->setValue(model_->pointsPerCurve() / 2);
}

void CurvePanel::connectHandle() {
  connect(drag_, &QToolButton::toggled, handle_, &CurveHandle::setEnabled);
  connect(handle_, &CurveHandle::grabbed, this, &CurvePanel::grab);
  connect(handle_, &CurveHandle::dragged, this, &CurvePanel::drag);
  connect(handle_, &CurveHandle::cancelled, this, [this] { show(beforeDrag_); });
}

CurveEdit CurvePanel::editOfControls() const {
  CurveEdit edit = CurveEdit::ofPoint(curve_->currentIndex(), point_->value(), model_->pointsPerCurve());
  edit.move = {dx_->value(), dy_->value(), dz_->value()};
  edit.setWidthDegrees(width_->value());
  edit.spread = spread_->value();
  edit.mirrored = mirror_->isChecked();
  return edit;
}

bool CurvePanel::show(const std::vector<CurveEdit>& edits) {
  model_->change([&](FaceState& state) { state.edits = edits; });
  return model_->update();
}

void CurvePanel::apply() {
  std::vector<CurveEdit> edits = model_->state().edits;
  edits.push_back(editOfControls());
  show(edits);
}

void CurvePanel::grab(int curve, int point) {
  beforeDrag_ = model_->state().edits;
  curve_->setCurrentIndex(curve);
  point_->setValue(point);
}

/// Through the controls, so that a drag is the edit that the same numbers make. A refused place leaves the curves as
/// they were before the drag, not at its last good place.
void CurvePanel::drag(const CurveHandle::Vector& move) {
  dx_->setValue(move[0]);
  dy_->setValue(move[1]);
  dz_->setValue(move[2]);
  std::vector<CurveEdit> edits = beforeDrag_;
  if (!editOfControls().move.isZero()) edits.push_back(editOfControls());
  if (show(edits) || model_->state().edits == beforeDrag_) return;
  show(beforeDrag_);
  show(edits);
}

void CurvePanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!ScanPanel::droppedFile(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void CurvePanel::dropEvent(QDropEvent* event) {
  scan_->openDropped(ScanPanel::droppedFile(event->mimeData()));
}

/// Who does not see the numbers does not move curves by accident.
void CurvePanel::hideEvent(QHideEvent* event) {
  drag_->setChecked(false);
  QWidget::hideEvent(event);
}

void CurvePanel::remove(int index) {
  if (index < 0 || index >= edits_->count()) return;
  model_->change([&](FaceState& state) { state.edits.erase(state.edits.begin() + index); });
  model_->update();
}

void CurvePanel::chooseSaved() {
  const QString name =
      FileDialog::save(window(), tr("Save the curves"), QString(), tr("Boundary curves (*.vtp)"), ".vtp");
  if (!name.isEmpty()) save(name);
}

bool CurvePanel::save(const QString& fileName) {
  const std::string fault = writeCurves(model_->state(), fileName.toStdString());
  if (fault.empty())
    emit model_->remarked(tr("%1 was written.").arg(QFileInfo(fileName).fileName()), fileName);
  else
    emit model_->failed(QString::fromStdString(fault), QString());
  return fault.empty();
}

void CurvePanel::showEdits() {
  const int chosen = edits_->currentRow();
  edits_->clear();
  for (const CurveEdit& edit : model_->state().edits) edits_->addItem(textOf(edit));
  edits_->setCurrentRow(std::min(chosen, edits_->count() - 1));
  remove_->setEnabled(edits_->currentRow() >= 0);
  hint_->setVisible(edits_->count() == 0);
  undo_->setEnabled(edits_->count() > 0);
  clear_->setEnabled(edits_->count() > 0);
}

}  // namespace mien
