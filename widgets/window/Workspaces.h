#pragma once

#include <QObject>
#include <QStringList>
#include <array>

#include "SessionPart.h"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;
class QTabBar;

namespace mien {

/// Arrangements of the docks for one kind of work each. Every one keeps what the user made of it, until the next start
/// and beyond.
/// @sa Remembered
class Workspaces : public QObject, public SessionPart {
  Q_OBJECT
 public:
  static constexpr int count = 4;

  /// Once all docks are in the window.
  explicit Workspaces(QMainWindow* window);

  QTabBar* bar() const { return bar_; }  ///< a tab for each, for the corner of the menu bar
  void addTo(QMenu* menu);               ///< an action for each, with its keys, and one that resets

  int current() const { return current_; }
  static QString title(int workspace);

  /// Which one it is; the arrangement itself is with the window.
  nlohmann::json sessionState() const override;
  void restoreSession(const nlohmann::json& state) override;
  bool isUndoable() const override { return false; }

  void choose(int workspace);  ///< @sa chosen
  void reset();                ///< the present one, to how it is at the first start
  void save() const;           ///< all of them, in the user's settings
  void restore();              ///< from there, or as at the first start

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 signals:
  void chosen();  ///< another one, by its tab or key

 private:
  struct Workspace;
  static const std::array<Workspace, count>& all();
  void buildBar();
  void show(int workspace);
  void arrange(int workspace);
  QList<QDockWidget*> stack(const QList<QDockWidget*>& left, bool isNarrow);
  QList<QDockWidget*> placeBelow(const QList<QDockWidget*>& below);
  void giveSizes(const QList<QDockWidget*>& left, const QList<QDockWidget*>& below);
  void giveHeights(const QList<QDockWidget*>& left, int room);
  QList<QDockWidget*> column() const;
  void closeGaps();
  void putAwayTabBars();
  static int hungryOf(const QList<QDockWidget*>& left);
  QList<QDockWidget*> docks(const QStringList& names) const;
  void follow();

  QMainWindow* window_;
  QTabBar* bar_;
  std::array<QAction*, count> actions_{};
  std::array<QByteArray, count> kept_;
  QByteArray first_;          ///< all docks where they belong
  bool isAsAtFirst_ = false;  ///< until the window is shown or somebody has arranged it
  int current_ = 0;
};

}  // namespace mien
