#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabBar>
#include <map>

#include "StudioFixture.h"

namespace {

using WidgetReach = StudioFixture;

template <class... Classes>
bool isOneOf(const QObject* object) {
  return (qobject_cast<const Classes*>(object) || ...);
}

bool isInput(const QWidget* widget) {
  if (widget->objectName().isEmpty() || widget->objectName().startsWith("qt_")) return false;
  if (isOneOf<QScrollBar>(widget) || isOneOf<QTabBar>(widget->parentWidget())) return false;
  return isOneOf<QAbstractButton, QComboBox, QAbstractSpinBox, QAbstractSlider, QLineEdit, QTabBar, QAbstractItemView,
                 QPlainTextEdit>(widget);
}

std::vector<QWidget*> inputsOf(const QWidget& window) {
  std::vector<QWidget*> inputs;
  for (auto* widget : window.findChildren<QWidget*>())
    if (isInput(widget)) inputs.push_back(widget);
  return inputs;
}

QString toolTipOf(const QWidget* widget) {
  const auto* tabs = qobject_cast<const QTabBar*>(widget);
  return tabs && tabs->toolTip().isEmpty() ? tabs->tabToolTip(0) : widget->toolTip();
}

bool hasMnemonic(const QWidget* widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  return button && !button->shortcut().isEmpty();
}

TEST_F(WidgetReach, EveryInputHasATooltipAndCanHaveTheFocus) {
  const auto inputs = inputsOf(*window);
  EXPECT_GT(inputs.size(), 200u);
  for (const QWidget* input : inputs) {
    const std::string name = input->objectName().toStdString();
    EXPECT_FALSE(toolTipOf(input).isEmpty()) << name;
    EXPECT_TRUE((input->focusPolicy() & Qt::TabFocus) || hasMnemonic(input)) << name;
  }
}

/// A number without a unit behind it says in its tooltip what it counts, or that it has none.
TEST_F(WidgetReach, EveryNumberTellsItsUnit) {
  for (const auto* number : window->findChildren<QDoubleSpinBox*>()) {
    const QString text = number->suffix() + number->prefix() + number->toolTip();
    bool tells = false;
    for (const char* unit : {"mm", "\u00b0", "unit", "%", "degrees", "rad"})
      tells = tells || text.contains(QString::fromUtf8(unit));
    EXPECT_TRUE(tells) << number->objectName().toStdString() << ": " << text.toStdString();
  }
}

TEST_F(WidgetReach, TabReachesEveryInputThatIsSeen) {
  QApplication::setActiveWindow(window.get());
  for (int workspace = 1; workspace <= 4; ++workspace) {
    find<QAction>(QString("actionWorkspace%1").arg(workspace))->trigger();
    settle();
    find<QWidget>("surfaceScheme")->setFocus();
    find<QWidget>("expression_joy")->setFocus();
    std::set<const QWidget*> reached;
    for (int i = 0; i < 400 && QApplication::focusWidget(); ++i) {
      reached.insert(QApplication::focusWidget());
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    EXPECT_GT(reached.size(), 30u);
    for (const QWidget* input : inputsOf(*window)) {
      const bool seen = input->isVisible() && input->isEnabled() && !input->visibleRegion().isEmpty();
      const bool isInside = input->focusProxy() || hasMnemonic(input);
      if (seen && !isInside) {
        EXPECT_TRUE(reached.count(input)) << workspace << " " << input->objectName().toStdString();
      }
    }
  }
}

using Uses = std::map<std::string, std::vector<std::string>>;

void expectOnce(const Uses& uses, const std::string& scope) {
  for (const auto& [keys, users] : uses) {
    std::string all;
    for (const std::string& user : users) all += " '" + user + "'";
    EXPECT_EQ(users.size(), 1u) << scope << ": " << keys << " is taken by" << all;
  }
}

void note(Uses& uses, const QKeySequence& keys, const QString& user) {
  if (!keys.isEmpty()) uses[keys.toString().toStdString()].push_back(user.toStdString());
}

void expectClearMenu(const QMenu& menu) {
  Uses uses;
  for (const QAction* action : menu.actions()) {
    note(uses, QKeySequence::mnemonic(action->text()), action->text());
    if (action->menu()) expectClearMenu(*action->menu());
  }
  expectOnce(uses, menu.title().toStdString());
}

TEST_F(WidgetReach, NoTwoMenuEntriesHaveOneLetter) {
  for (const QAction* action : window->menuBar()->actions())
    if (action->menu()) expectClearMenu(*action->menu());
}

TEST_F(WidgetReach, NoKeysHaveTwoMeanings) {
  Uses uses;
  for (const QAction* action : window->menuBar()->actions())
    note(uses, QKeySequence::mnemonic(action->text()), action->text());
  for (const auto* action : window->findChildren<QAction*>())
    if (action->shortcutContext() != Qt::WidgetShortcut && action->shortcutContext() != Qt::WidgetWithChildrenShortcut)
      for (const QKeySequence& keys : action->shortcuts()) note(uses, keys, action->text());
  for (const auto* button : window->findChildren<QAbstractButton*>())
    note(uses, button->shortcut(), button->objectName() + ' ' + button->text());
  for (const auto* label : window->findChildren<QLabel*>())
    if (label->buddy()) note(uses, QKeySequence::mnemonic(label->text()), label->text());
  expectOnce(uses, "the window");
}

}  // namespace
