#include "Workspaces.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QEvent>
#include <QLayout>
#include <QMainWindow>
#include <QMenu>
#include <QSignalBlocker>
#include <QTabBar>
#include <QTimer>
#include <QVariant>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "Remembered.h"
#include "SessionPart.h"

namespace mien {

namespace {

constexpr int version = 2;  // of the docks; one more when their names change
constexpr const char* currentKey = "window/workspace";
constexpr int leftWidth = 350, leastBelow = 320, leastOfRows = 368;  // pixels
constexpr double shareBelow = 0.4;                                   // of the window, for docks with a picture
constexpr double mostBelow = 0.44;             // of a low window, for the face is to be seen as well
constexpr int menuHeight = 26, separator = 6;  // pixels, of the theme
constexpr int leastHeight = 150;               // pixels of the dock that takes what is left
constexpr int high = 1000, wide = 900;         // pixels of a window with room for the FAPs; of one dock of several
constexpr int low = 760;                       // pixels of a window in which the FAPs need the room below them
constexpr int narrow = 1200;                   // pixels of a window in which a dock needs all of the width

constexpr const char* growing = "fapDock";

QByteArray keyOf(int workspace) {
  return "window/workspaces/" + QByteArray::number(workspace);
}

}  // namespace

/// Docks at the left from top to bottom, and below the face, in tabs, the first one in front, or beside each other
/// where a window is wide. In a high one the FAPs take what the others leave at the left.
struct Workspaces::Workspace {
  const char *title, *mnemonic, *purpose;
  QStringList left, below;
  bool hasRows;  // below: a table
};

const std::array<Workspaces::Workspace, Workspaces::count>& Workspaces::all() {
  static const std::array<Workspace, count> workspaces = {{{QT_TR_NOOP("Animate"),
                                                            QT_TR_NOOP("&Animate"),
                                                            QT_TR_NOOP("Expressions, FAPs and .fap files"),
                                                            {"expressionDock", "fapDock", "surfaceDock"},
                                                            {},
                                                            false},
                                                           {QT_TR_NOOP("Surface"),
                                                            QT_TR_NOOP("&Surface"),
                                                            QT_TR_NOOP("How scheme, a and N shape the surface"),
                                                            {"surfaceDock", "expressionDock"},
                                                            {"spectrumDock", "smoothingDock", "continuityDock"},
                                                            false},
                                                           {QT_TR_NOOP("Deform"),
                                                            QT_TR_NOOP("&Deform"),
                                                            QT_TR_NOOP("Facial deformation tables and motion"),
                                                            {"expressionDock", "fapDock"},
                                                            {"deformationDock", "vectorsDock"},
                                                            true},
                                                           {QT_TR_NOOP("Acquire"),
                                                            QT_TR_NOOP("A&cquire"),
                                                            QT_TR_NOOP("Curves of a scan, and textures"),
                                                            {"surfaceDock", "expressionDock"},
                                                            {"curvesDock", "textureDock"},
                                                            false}}};
  return workspaces;
}

Workspaces::Workspaces(QMainWindow* window)
    : QObject(window), window_(window), bar_(new QTabBar(window)), first_(window->saveState(version)) {
  setObjectName(arrangementPart);
  window->installEventFilter(this);
  buildBar();
}

QString Workspaces::title(int workspace) {
  return tr(all()[workspace].title);
}

void Workspaces::buildBar() {
  bar_->setObjectName("workspaces");
  bar_->setProperty(notInSession, true);  // the arrangement itself is
  bar_->setDrawBase(false);
  bar_->setExpanding(false);
  bar_->setUsesScrollButtons(false);
  bar_->setFocusPolicy(Qt::TabFocus);
  bar_->setToolTip(tr("Workspaces: which docks are open, and where"));
  bar_->setAccessibleName(tr("Workspaces"));
  for (int i = 0; i < count; ++i) {
    bar_->addTab(title(i));
    bar_->setTabToolTip(i, tr("%1 (Ctrl+F%2)").arg(tr(all()[i].purpose)).arg(i + 1));
  }
  connect(bar_, &QTabBar::currentChanged, this, &Workspaces::choose);
}

void Workspaces::addTo(QMenu* menu) {
  auto* group = new QActionGroup(this);
  for (int i = 0; i < count; ++i) {
    QAction* action = menu->addAction(tr(all()[i].mnemonic), this, [this, i] { choose(i); });
    action->setObjectName(QString("actionWorkspace%1").arg(i + 1));
    action->setProperty(notInSession, true);
    action->setCheckable(true);
    action->setShortcut(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_F1 + i)));
    actions_[i] = group->addAction(action);
  }
  menu->addSeparator();
  menu->addAction(tr("&Reset this workspace"), this, &Workspaces::reset)->setObjectName("actionResetWorkspace");
  follow();
}

void Workspaces::choose(int workspace) {
  isAsAtFirst_ = false;
  if (workspace != current_ && workspace >= 0) {
    kept_[current_] = window_->saveState(version);
    show(workspace);
    emit chosen();
  }
  follow();
}

void Workspaces::reset() {
  kept_[current_].clear();
  arrange(current_);
}

void Workspaces::show(int workspace) {
  current_ = workspace;
  if (kept_[workspace].isEmpty() || !window_->restoreState(kept_[workspace], version)) arrange(workspace);
  QTimer::singleShot(0, this, &Workspaces::closeGaps);  // once the docks have their places
}

QList<QDockWidget*> Workspaces::docks(const QStringList& names) const {
  QList<QDockWidget*> found;
  for (const QString& name : names)
    if (auto* dock = window_->findChild<QDockWidget*>(name)) found << dock;
  return found;
}

/// The docks below lie beneath those at the left as well where these have no use for the height, and in a narrow
/// window, where their tables need its width.
void Workspaces::arrange(int workspace) {
  const QSize size = window_->size();
  QStringList atLeft = all()[workspace].left;
  if (size.height() >= high && !atLeft.contains(growing)) atLeft << growing;
  const QList<QDockWidget*> left = docks(atLeft), below = docks(all()[workspace].below);
  window_->restoreState(first_, version);
  const bool isNarrow = size.width() < narrow && size.height() < high && !below.isEmpty();
  const bool isFull = atLeft.contains(growing) && !isNarrow;
  window_->setCorner(Qt::BottomLeftCorner, isFull ? Qt::LeftDockWidgetArea : Qt::BottomDockWidgetArea);
  const QList<QDockWidget*> fronts = placeBelow(below);
  for (auto* dock : window_->findChildren<QDockWidget*>())
    dock->setVisible(left.contains(dock) || below.contains(dock));
  giveSizes(stack(left, isNarrow), fronts);
  for (QDockWidget* dock : fronts) dock->raise();
  window_->layout()->activate();
  window_->resize(size);  // while docks were on their way it may have grown
}

/// One below the other; in a narrow window the FAPs, which need height, in a tab, and in a low one what would leave
/// them too little of it. @return those that are seen
QList<QDockWidget*> Workspaces::stack(const QList<QDockWidget*>& left, bool isNarrow) {
  QList<QDockWidget*> seen = left.mid(0, 1);
  for (QDockWidget* dock : left.mid(1)) {
    const bool isLow = window_->height() < low && seen.back()->objectName() == growing;
    const bool isBehind = isLow || (isNarrow && dock->objectName() == growing);
    isBehind ? window_->tabifyDockWidget(seen.back(), dock) : window_->splitDockWidget(seen.back(), dock, Qt::Vertical);
    if (isBehind)
      seen.back()->raise();
    else
      seen << dock;
  }
  return seen;
}

/// In as many columns as there is room for. @return the first dock of each
QList<QDockWidget*> Workspaces::placeBelow(const QList<QDockWidget*>& below) {
  const int columns = std::clamp((window_->width() - leftWidth) / wide, 1, std::max(1, static_cast<int>(below.size())));
  QList<QDockWidget*> lasts = below.mid(0, columns), fronts = lasts;
  for (int i = 1; i < columns; ++i) {
    window_->removeDockWidget(fronts[i]);  // from among the tabs
    window_->addDockWidget(Qt::BottomDockWidgetArea, fronts[i], Qt::Horizontal);
  }
  for (int i = columns; i < below.size(); ++i)
    window_->tabifyDockWidget(std::exchange(lasts[columns - 1], below[i]), below[i]);
  return fronts;
}

void Workspaces::giveSizes(const QList<QDockWidget*>& left, const QList<QDockWidget*>& below) {
  const double wanted =
      std::max<double>(all()[current_].hasRows ? leastOfRows : leastBelow, shareBelow * window_->height());
  const int height = static_cast<int>(std::min(wanted, mostBelow * window_->height()));
  const bool isFull = window_->corner(Qt::BottomLeftCorner) == Qt::LeftDockWidgetArea;
  giveHeights(left, window_->height() - menuHeight - (isFull || below.isEmpty() ? 0 : height + separator));
  window_->resizeDocks(left, QList<int>::fromVector(QVector<int>(left.size(), leftWidth)), Qt::Horizontal);
  if (below.isEmpty()) return;
  window_->resizeDocks({below.front()}, {height}, Qt::Vertical);
  window_->resizeDocks(below, QList<int>::fromVector(QVector<int>(below.size(), window_->width())), Qt::Horizontal);
}

bool Workspaces::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show && std::exchange(isAsAtFirst_, false)) arrange(current_);  // its size is known now
  if (event->type() == QEvent::Resize) QTimer::singleShot(0, this, &Workspaces::closeGaps);
  if (event->type() == QEvent::LayoutRequest) QTimer::singleShot(0, this, &Workspaces::putAwayTabBars);
  return QObject::eventFilter(watched, event);
}

/// Qt leaves the bar of docks that were tabs and are hidden or elsewhere now where it was: a line across what lies
/// there, which takes its clicks as well. It puts other bars without tabs out of sight in this way.
void Workspaces::putAwayTabBars() {
  for (auto* bar : window_->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
    if (bar->isVisible() && bar->count() == 0) bar->move(-2 * bar->width(), -2 * bar->height());
}

/// From top to bottom; empty where they are not one column.
QList<QDockWidget*> Workspaces::column() const {
  QList<QDockWidget*> left;
  for (auto* dock : window_->findChildren<QDockWidget*>()) {
    if (!dock->isVisible() || dock->isFloating() || window_->dockWidgetArea(dock) != Qt::LeftDockWidgetArea) continue;
    if (!window_->tabifiedDockWidgets(dock).isEmpty() || (!left.isEmpty() && left.front()->x() != dock->x())) return {};
    left << dock;
  }
  std::sort(left.begin(), left.end(), [](const QDockWidget* a, const QDockWidget* b) { return a->y() < b->y(); });
  return left;
}

/// A window that has changed its size gives each dock a share, also those that have no use for it: what is beyond their
/// need goes to the one that takes what is left.
void Workspaces::closeGaps() {
  putAwayTabBars();
  const QList<QDockWidget*> left = column();
  if (left.size() < 2) return;
  const int hungry = hungryOf(left);
  QList<int> heights;
  int spare = 0;
  for (int i = 0; i < left.size(); ++i) {
    const int need = i == hungry ? left[i]->height() : std::min(left[i]->height(), left[i]->sizeHint().height());
    spare += left[i]->height() - need;
    heights << need;
  }
  if (spare == 0) return;
  heights[hungry] += spare;
  window_->resizeDocks(left, heights, Qt::Vertical);
}

int Workspaces::hungryOf(const QList<QDockWidget*>& left) {
  int hungry = left.size() - 1;
  for (int i = 0; i < left.size(); ++i)
    if (left[i]->objectName() == growing) hungry = i;
  return hungry;
}

/// The last dock at the left takes what room the others do not need, or the table of FAPs, which has use for it.
void Workspaces::giveHeights(const QList<QDockWidget*>& left, int room) {
  QList<int> heights;
  for (const QDockWidget* dock : left) heights << dock->sizeHint().height();
  const int hungry = hungryOf(left);
  const int others = std::accumulate(heights.begin(), heights.end(), 0) - heights[hungry];
  heights[hungry] = std::max(leastHeight, room - others - separator * (left.size() - 1));
  window_->resizeDocks(left, heights, Qt::Vertical);
}

void Workspaces::follow() {
  const QSignalBlocker quiet(bar_);
  bar_->setCurrentIndex(current_);
  for (int i = 0; i < count; ++i)
    if (actions_[i]) actions_[i]->setChecked(i == current_);
}

nlohmann::json Workspaces::sessionState() const {
  return all()[current_].title;
}

void Workspaces::restoreSession(const nlohmann::json& state) {
  isAsAtFirst_ = false;
  for (int i = 0; i < count; ++i)
    if (state == all()[i].title) current_ = i;
  follow();
}

void Workspaces::save() const {
  Remembered::set(currentKey, current_);
  for (int i = 0; i < count; ++i) Remembered::set(keyOf(i), i == current_ ? window_->saveState(version) : kept_[i]);
}

void Workspaces::restore() {
  for (int i = 0; i < count; ++i) kept_[i] = Remembered::value(keyOf(i), QByteArray()).toByteArray();
  show(std::clamp(Remembered::value(currentKey, 0).toInt(), 0, count - 1));
  isAsAtFirst_ = kept_[current_].isEmpty();
  follow();
}

}  // namespace mien
