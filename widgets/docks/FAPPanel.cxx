#include "FAPPanel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "FAPList.h"
#include "FAPRow.h"
#include "FAPTable.h"
#include "FaceModel.h"
#include "Remembered.h"
#include "RowScroll.h"
#include "SessionPart.h"

namespace mien {

namespace {

/// The groups of the standard that the 22 FAPs come from, from the top of the face down.
constexpr int brows = 4, eyes = 3, cheeks = 5, nose = 9, mouth = 8;

constexpr int pageMargins = 14, rowSpacing = 1;  // pixels
constexpr int highPanel = 560;                   // pixels: twice the rows of a tab

constexpr const char* mirrorKey = "faps/mirror";
constexpr const char* allKey = "faps/all";

/// A missing value is 0, so that a face with all sliders at rest equals the neutral one.
void setFAP(FaceState& state, int fap, double value) {
  if (value == 0.0)
    state.fapValues.erase(fap);
  else
    state.fapValues[fap] = value;
}

bool isShown(const FAPDefinition& fap) {
  return fap.number >= FAPFrame::firstLowLevel && fap.hasSurface;
}

}  // namespace

FAPPanel::FAPPanel(FaceModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      all_(new QToolButton(this)),
      search_(new QLineEdit(this)),
      tabs_(new QTabBar(this)),
      head_(new QStackedWidget(this)),
      pages_(new QStackedWidget(this)),
      list_(new FAPList(pages_)),
      mirror_(new QCheckBox(tr("&Mirror lock"), this)) {
  setObjectName("fapPanel");
  tabs_->setObjectName("fapTabs");
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->setUsesScrollButtons(false);
  addTab(brows, tr("Brows"));
  addTab(eyes, tr("Eyes"));
  addTab(cheeks, tr("Cheeks"));
  addTab(nose, tr("Nose"));
  addTab(mouth, tr("Mouth"));
  pages_->addWidget(list_);
  for (const FAPDefinition& fap : fapTable)
    if (isShown(fap)) addRow(fap.number);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 0, 8, 8);
  column->setSpacing(4);
  column->addWidget(header());
  column->addWidget(pages_, 1);
  column->addWidget(footer());
  column->addStretch();  // below all, and not between the last FAP and the lock
  connect(model_, &FaceModel::stateChanged, this, &FAPPanel::follow);
  connect(model_, &FaceModel::updated, this, &FAPPanel::follow);
  connect(model_, &FaceModel::tableChanged, this, &FAPPanel::followTable);
  arrange();
  showPartners();
  followTable();
  follow();
}

/// The tabs, or in their place the search, and beside them what changes between them.
QWidget* FAPPanel::header() {
  auto* bar = new QWidget(this);
  bar->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  head_->addWidget(tabs_);
  head_->addWidget(searchField());
  all_->setObjectName("fapAll");
  all_->setText(tr("All FAPs"));
  all_->setProperty("framed", true);
  all_->setToolTip(
      tr("Every low-level FAP that this face has surface for, in one list; again: the 22 of Sheng et al. 2011"));
  all_->setCheckable(true);
  all_->setChecked(Remembered::value(allKey, false).toBool());
  all_->setFocusPolicy(Qt::TabFocus);
  connect(tabs_, &QTabBar::currentChanged, this, &FAPPanel::arrange);
  isChosen_ = Remembered::value(allKey, QVariant()).isValid();
  all_->setProperty(notInSession, !isChosen_);
  connect(all_, &QToolButton::toggled, this, [this](bool on) {
    arrange();
    if (isFitting_) return;
    isChosen_ = true;
    all_->setProperty(notInSession, false);
    Remembered::set(allKey, on);
    if (on) search_->setFocus();
  });
  row->addWidget(head_, 1);
  row->addWidget(all_);
  return bar;
}

QWidget* FAPPanel::searchField() {
  search_->setObjectName("fapSearch");
  search_->setPlaceholderText(tr("Find a FAP: brow, 31, 4.1"));
  search_->setToolTip(tr("Finds by name, number or feature point"));
  search_->setAccessibleName(tr("Find a FAP"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, list_, &FAPList::filter);
  return search_;
}

void FAPPanel::addTab(int group, const QString& title) {
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(2, 2, 2, 2);
  column->setSpacing(7);
  auto* rows = new QVBoxLayout;
  rows->setSpacing(rowSpacing);
  column->addLayout(rows);
  column->addStretch();
  tabColumns_.insert(group, rows);
  auto* scroll = new RowScroll(pages_);  // a low screen must hold the docks above and below
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(page);
  scroll->spread(rows);
  pages_->addWidget(scroll);
  tabs_->setTabToolTip(tabs_->addTab(title),
                       tr("Those of the 22 FAPs of Sheng et al. 2011 that move the %1").arg(title.toLower()));
}

void FAPPanel::addRow(int fap) {
  auto* row = new FAPRow(fapDefinition(fap), model_->millimetresPerUnit(fap), this);
  row->hide();
  connect(row, &FAPRow::valueEdited, this, &FAPPanel::edit);
  rows_.insert(fap, row);
}

/// Each FAP has one row, which moves between the tabs and the list, so that its value stays.
void FAPPanel::arrange() {
  const bool isList = all_->isChecked();
  head_->setCurrentIndex(isList ? 1 : 0);
  pages_->setMaximumHeight(QWIDGETSIZE_MAX);
  if (isList) {
    list_->take(rows_);
    list_->filter(search_->text());
    return pages_->setCurrentWidget(list_);
  }
  int tallest = 0;
  for (int fap : paperSubset()) {
    tabColumns_.value(fapDefinition(fap).group)->addWidget(rows_.value(fap));
    rows_.value(fap)->show();
  }
  pages_->setCurrentIndex(tabs_->currentIndex());
  for (QVBoxLayout* rows : qAsConst(tabColumns_)) {
    rows->setSpacing(rowSpacing);  // which may be spread
    tallest = std::max(tallest, rows->sizeHint().height());
  }
  pages_->setMaximumHeight(tallest + pageMargins);
}

QWidget* FAPPanel::footer() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  mirror_->setObjectName("fapMirror");
  mirror_->setToolTip(
      tr("A FAP of one side takes its partner on the other side along, so that the face stays symmetric; FAPs marked "
         "\u21c4 have a partner (Alt+M)"));
  mirror_->setChecked(Remembered::value(mirrorKey, true).toBool());
  connect(mirror_, &QCheckBox::toggled, this, [this](bool on) {
    Remembered::set(mirrorKey, on);
    showPartners();
  });
  auto* reset = new QPushButton(tr("Rese&t all FAPs"), bar);
  reset->setProperty("compact", true);
  reset->setObjectName("fapResetAll");
  reset->setToolTip(tr("Every FAP back to 0; an expression and an animation stay"));
  connect(reset, &QPushButton::clicked, this, &FAPPanel::resetAll);
  row->addWidget(mirror_);
  row->addStretch();
  row->addWidget(reset);
  return bar;
}

/// Until the user has chosen, all FAPs are listed where the 22 of one tab would leave most of the panel empty.
void FAPPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (isChosen_) return;
  const QScopedValueRollback<bool> fitting(isFitting_, true);
  all_->setChecked(height() >= highPanel);
}

void FAPPanel::showPartners() {
  for (FAPRow* row : qAsConst(rows_)) row->setPartnerShown(mirror_->isChecked());
}

void FAPPanel::edit(int fap, double value) {
  const FAPDefinition& definition = fapDefinition(fap);
  const bool both = mirror_->isChecked() && definition.mirrorPartner != fap;
  model_->change([&](FaceState& state) {
    setFAP(state, fap, value);
    if (both) setFAP(state, definition.mirrorPartner, definition.mirrorSign * value);
  });
}

void FAPPanel::resetAll() {
  model_->change([](FaceState& state) { state.fapValues.clear(); });
}

void FAPPanel::follow() {
  for (auto it = rows_.cbegin(); it != rows_.cend(); ++it) {
    const auto found = model_->state().fapValues.find(it.key());
    it.value()->setValue(found == model_->state().fapValues.end() ? 0.0 : found->second);
    it.value()->setShownValue(model_->shownFAP(it.key()));
  }
}

/// What the animation table does not move cannot be set either.
void FAPPanel::followTable() {
  for (FAPRow* row : qAsConst(rows_))
    row->setReason(model_->moves(row->fap())
                       ? QString()
                       : tr("The animation table moves nothing for this FAP, so it cannot be set."));
}

}  // namespace mien
