#include "DeformationPanel.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QStackedWidget>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "CoefficientTable.h"
#include "DeformationChoice.h"
#include "ElidedLabel.h"
#include "EmptyState.h"
#include "ExportButton.h"
#include "FaceModel.h"
#include "FaceNote.h"
#include "FaceView.h"
#include "FigureView.h"
#include "FitBar.h"
#include "FlipBox.h"
#include "LiveUpdate.h"
#include "NamedTables.h"
#include "OverflowRow.h"
#include "PresentTable.h"
#include "RecognitionFigure.h"
#include "RegionOverlay.h"
#include "WholeRows.h"

namespace mien {

namespace {

enum Shown { Present, Chosen };
enum Page { Empty, Results, Fitting };
constexpr int leastFigure = 180;  // pixels beside the table
const QPoint unitPlace(4, 1);
constexpr int nearestMean = 0;  // first entry of the means; the expressions follow

QString droppedTable(const QMimeData* data) {
  for (const QUrl& url : data->urls())
    for (const char* ending : {".csv", ".fdt"})
      if (url.isLocalFile() && url.toLocalFile().endsWith(ending, Qt::CaseInsensitive)) return url.toLocalFile();
  return {};
}

}  // namespace

DeformationPanel::DeformationPanel(FaceModel* model, FaceView* view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      present_(new PresentTable(model, this)),
      choice_(new DeformationChoice(model, this)),
      overlay_(new RegionOverlay(model, view, this)),
      coefficients_(new CoefficientTable(this)),
      figure_(new FigureView("deformationFigure", FigureView::Marker::Band, this)),
      pages_(new QStackedWidget(this)),
      range_(new QWidget(this)),
      shown_(new QComboBox(this)),
      mean_(new QComboBox(this)),
      detail_(new ElidedLabel(this)),
      origin_(new ElidedLabel(this)),
      expression_(new ElidedLabel(this)),
      unit_(new QLabel(tr("Not explained (pu)"), figure_)),
      onFace_(new QToolButton(this)) {
  setObjectName("deformationPanel");
  setAcceptDrops(true);
  describeControls();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(4);
  column->addWidget(controls());
  column->addWidget(fitRow());
  auto* results = new QWidget(pages_);
  auto* rows = new QVBoxLayout(results);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  auto* both = new FlipBox(new WholeRows(coefficients_, CoefficientTable::leastLine, CoefficientTable::mostLine, this),
                           expressionColumn(), 3, 1, this);
  both->showAllOfFirst(leastFigure);
  rows->addWidget(both, 1);
  rows->addWidget(detailRow());
  pages_->addWidget(emptyState());
  pages_->addWidget(results);
  auto* fitting = new QLabel(tr("Fitting the table that moves the face so ..."), pages_);
  fitting->setObjectName("deformationFitting");
  fitting->setAlignment(Qt::AlignCenter);
  fitting->setMinimumWidth(1);
  pages_->addWidget(fitting);
  column->addWidget(pages_, 1);
  connectControls();
  new LiveUpdate(
      model, this, [this] { refresh(); }, [this] { return overlay_->isShown(); });
}

DeformationPanel::~DeformationPanel() = default;

void DeformationPanel::describeControls() {
  onFace_->setObjectName("deformationRegions");
  onFace_->setText(tr("Regions"));
  onFace_->setCheckable(true);
  onFace_->setFocusPolicy(Qt::TabFocus);
  onFace_->setToolTip(tr("Colours and numbers the 16 regions on the face; again: the plain skin"));
  shown_->setObjectName("deformationShown");
  shown_->setAccessibleName(tr("Whose coefficients are shown"));
  shown_->addItems({tr("Present face"), tr("Chosen table")});
  shown_->setToolTip(
      tr("The coefficients of the table fitted from A to the present face, or of the table that bends it"));
  mean_->setObjectName("deformationMean");
  mean_->setAccessibleName(tr("Expression whose range is shown"));
  mean_->addItem(tr("Nearest mean"));
  for (const std::string& name : PresentTable::expressions()) mean_->addItem(QString::fromStdString(name));
  mean_->setToolTip(tr("The expression whose mean \u00b1 standard deviation over 12 subjects is the acceptable range"));
  detail_->setObjectName("deformationDetail");
  expression_->setObjectName("deformationExpression");
  detail_->setProperty("faint", true);
  origin_->setObjectName("deformationOrigin");
  origin_->setProperty("faint", true);
  origin_->setToolTip(tr("The neutral face A that the table is fitted from"));
  expression_->setProperty("heading", true);
  figure_->setMinimumWidth(leastFigure);
  figure_->setAccessibleName(tr("Movement that each expression does not explain"));
  figure_->setToolTip(
      tr("RMS of the movement that each mean table does not explain, in pupil units: the shortest bar is nearest. "
         "Click a bar, or use the arrow keys, to see that expression's range"));
}

QWidget* DeformationPanel::controls() {
  auto* row = new OverflowRow("deformationControls", this);
  row->addWidget(choice_);
  row->addWidget(onFace_, 1);
  row->addWidget(new ExportButton(
                     "deformationExport", model_,
                     [this](const ExportOptions& options) { return ExportDrawing(figure(), options); },
                     [this] { return coefficients_->text(); }, row),
                 2);
  return row;
}

/// One click shows what the dock is for.
EmptyState* DeformationPanel::emptyState() {
  auto* empty = new EmptyState(
      "deformationEmpty", tr("Nothing moves the face yet"),
      tr("A facial deformation table bends 16 regions of the face with twelve coefficients each. Choose one above, "
         "drop "
         "a file here, or take an example. Or move the face by expressions and FAPs: then the table that does the same "
         "is fitted, and the expression it is nearest to is named."),
      pages_);
  for (const std::string& name : PresentTable::expressions()) {
    const QString title = QString::fromStdString(name);
    QToolButton* example = empty->addButton("deformationExample_" + title, title.left(1).toUpper() + title.mid(1),
                                            tr("Bends the face by the mean table of %1 over 12 subjects").arg(title));
    connect(example, &QToolButton::clicked, this, [this, name] {
      model_->change([&](FaceState& state) {
        state.deformation.table = name;
        state.deformation.strength = 1.0;
      });
    });
  }
  return empty;
}

/// The fit, and whose coefficients the table shows.
QWidget* DeformationPanel::fitRow() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new FitBar(model_, present_, this), 1);
  auto* choices = new QHBoxLayout(range_);
  choices->setContentsMargins(0, 0, 0, 0);
  choices->addWidget(shown_);
  choices->addWidget(new QLabel(tr("against"), range_));
  choices->addWidget(mean_);
  QSizePolicy policy = range_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);  // the status keeps its place
  range_->setSizePolicy(policy);
  row->addWidget(range_);
  return box;
}

/// The coefficient that is chosen in words, and what the table was fitted from.
QWidget* DeformationPanel::detailRow() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(detail_, 1);
  row->addWidget(origin_);
  return box;
}

QWidget* DeformationPanel::expressionColumn() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(expression_);
  unit_->setObjectName("deformationUnit");
  unit_->setProperty("faint", true);
  unit_->setAttribute(Qt::WA_TransparentForMouseEvents);
  unit_->move(unitPlace);  // in the figure's margin: as a title it would take room from the bars
  column->addWidget(figure_, 1);
  return box;
}

void DeformationPanel::connectControls() {
  const auto chosen = QOverload<int>::of(&QComboBox::currentIndexChanged);
  connect(shown_, chosen, this, &DeformationPanel::showCoefficients);
  connect(mean_, chosen, this, [this] {
    showExpression();
    showCoefficients();
  });
  connect(present_, &PresentTable::changed, this, [this] {
    showExpression();
    showCoefficients();
    showPage();
  });
  connect(shown_, chosen, this, &DeformationPanel::showPage);
  connect(model_, &FaceModel::stateChanged, this, &DeformationPanel::showPage);
  connect(figure_, &FigureView::picked, this, [this](double x) {
    mean_->setCurrentIndex(std::clamp(static_cast<int>(std::lround(x)) + 1, 1, mean_->count() - 1));
  });
  connect(figure_, &FigureView::stepped, this, [this](int steps) {
    const int from = mean_->currentIndex() == nearestMean ? nearest() + 1 : mean_->currentIndex();
    mean_->setCurrentIndex(std::clamp(from + steps, 1, mean_->count() - 1));
  });
  connect(coefficients_, &QTableWidget::currentCellChanged, this, [this] { showRegion(false); });
  connect(coefficients_, &QTableWidget::cellClicked, this, [this] { showRegion(true); });
  connect(coefficients_, &QTableWidget::cellActivated, this, [this] { showRegion(true); });
  connect(onFace_, &QToolButton::toggled, this, [this](bool on) {
    if (on == overlay_->isShown()) return;
    overlay_->emphasise(0);
    on ? overlay_->show() : overlay_->hide();
    onFace_->setChecked(overlay_->isShown());
  });
  connect(overlay_, &RegionOverlay::shownChanged, onFace_, &QToolButton::setChecked);
}

void DeformationPanel::refresh() {
  present_->request();
  if (overlay_->isShown()) overlay_->show();
}

/// The nearest expression, from 0; the first when nothing moves.
int DeformationPanel::nearest() const {
  const auto& fit = present_->fit();
  return fit && fit->moves() && !fit->scores.empty() ? fit->scores.front().expression : 0;
}

Figure DeformationPanel::figure() const {
  const auto& fit = present_->fit();
  if (!fit || !fit->fault.isEmpty() || !fit->moves()) return {};
  Figure figure = recognitionFigure(PresentTable::expressions(), fit->scores);
  const FaceState state = model_->lastingState();
  figure.note = faceNote(state, {state.surface.scheme}, true, model_->frameText()) +
                "; from A: " + present_->neutralText().toStdString();
  return figure;
}

void DeformationPanel::showExpression() {
  Figure shown = figure();
  const auto& fit = present_->fit();
  expression_->setVisible(!shown.panels.empty());
  unit_->setVisible(!shown.panels.empty());
  if (shown.panels.empty()) {
    figure_->setHint(fit ? fit->fault.isEmpty() ? tr("The face does not move: there is no expression to name.")
                                                : fit->fault
                         : QString());
  } else {
    const RecognitionScore& score = fit->scores.front();
    const QString name = QString::fromStdString(PresentTable::expressions()[score.expression]);
    const QString percent = QString::number(100.0 * score.intensity, 'f', 0);
    expression_->setText(tr("Nearest: %1, %2 %").arg(name, percent));
    expression_->setToolTip(tr("The movement from A to the present face is nearest to %2 % of the mean %1 table: the "
                               "one that explains most of it, at the factor, 50 % to 150 %, that suits it best")
                                .arg(name, percent));
    shown.title.clear();
    shown.caption.clear();
    shown.note.clear();
    shown.panels.front().x.title.clear();
    shown.panels.front().y.title.clear();  // unit_ says it
    shown.panels.front().y.unit.clear();
  }
  figure_->setFigure(shown);
  figure_->setMarked(mean_->currentIndex() == nearestMean ? nearest() : mean_->currentIndex() - 1);
}

void DeformationPanel::showCoefficients() {
  const bool ofPresent = shown_->currentIndex() == Present;
  const auto& fit = present_->fit();
  if (!fit) return;
  DeformationTable table = fit->table;
  const std::string& chosen = model_->state().deformation.table;
  if (!ofPresent) table = DeformationTable();                                           // without one nothing moves
  if (!ofPresent && !chosen.empty() && !readNamedTable(chosen, table).empty()) return;  // the model has said why
  const bool none = mean_->currentIndex() == nearestMean && !(fit->fault.isEmpty() && fit->moves());
  const int mean = mean_->currentIndex() == nearestMean ? nearest() : mean_->currentIndex() - 1;
  const std::string& name = PresentTable::expressions()[mean];
  coefficients_->show(table, name, none ? nullptr : namedTable(name), ofPresent ? &*fit : nullptr);
  detail_->setText(coefficients_->detail());
  origin_->setText(ofPresent ? tr("A: %1").arg(present_->neutralText()) : QString());
}

/// Numbers that say nothing, of a face that does not move, give way to what can be done. A table that is chosen is
/// shown also where its strength is nothing. A face that has just begun to move waits for its first numbers.
void DeformationPanel::showPage() {
  const auto& fit = present_->fit();
  const bool moves = fit && (!fit->fault.isEmpty() || fit->moves());
  const bool isChosen = shown_->currentIndex() == Chosen && !model_->state().deformation.table.empty();
  const bool isMoved = !model_->motionText().empty() || !model_->state().deformation.table.empty();
  pages_->setCurrentIndex(moves || isChosen ? Results : isMoved && !present_->isOfPresentFace() ? Fitting : Empty);
  range_->setVisible(moves || isChosen);
}

/// @param asked  by the user, for this region; else a region that is on the face already gives way to the next
void DeformationPanel::showRegion(bool asked) {
  detail_->setText(coefficients_->detail());
  if (!asked && !overlay_->isShown()) return;
  overlay_->emphasise(coefficients_->chosenRegion());
  if (!overlay_->isShown()) overlay_->show();
}

void DeformationPanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedTable(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void DeformationPanel::dropEvent(QDropEvent* event) {
  choice_->open(droppedTable(event->mimeData()));
  event->acceptProposedAction();
}

}  // namespace mien
