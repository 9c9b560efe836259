#include "Theme.h"

#include <QApplication>
#include <QPalette>
#include <QString>
#include <QVariant>

#include "Remembered.h"
#include "StudioStyle.h"

namespace mien {

namespace {

const Theme* applied = nullptr;

constexpr const char* darkKey = "window/dark";
constexpr int middleGrey = 128;

Theme light() {
  Theme theme;
  theme.kind = Theme::Kind::Light;
  theme.window = "#f4f5f7";
  theme.panel = "#ffffff";
  theme.text = "#1f2933";
  theme.faintText = "#5f6c7b";
  theme.line = "#d5dae1";
  theme.edge = "#767f8b";
  theme.accent = "#2f6fb2";
  theme.accentText = "#ffffff";
  theme.error = "#b3372f";
  theme.warning = "#96690a";
  theme.viewTop = "#dfe5ec";
  theme.viewBottom = "#f7f8fa";
  theme.skin = "#dccbc0";
  theme.skinInside = "#857b77";
  theme.mesh = "#3a4654";
  theme.meshAlone = "#3a4654";
  theme.curve = "#3f5f80";
  theme.curveMoved = "#d9570a";
  theme.ghost = "#aeb8c4";
  return theme;
}

Theme dark() {
  Theme theme;
  theme.kind = Theme::Kind::Dark;
  theme.window = "#23272e";
  theme.panel = "#2b3038";
  theme.text = "#e4e8ed";
  theme.faintText = "#9aa6b4";
  theme.line = "#414954";
  theme.edge = "#7f8996";
  theme.accent = "#5b9bdc";
  theme.accentText = "#10151b";
  theme.error = "#ec7f76";
  theme.warning = "#e2b04a";
  theme.viewTop = "#3a424d";
  theme.viewBottom = "#22272e";
  theme.skin = "#d3c2b7";
  theme.skinInside = "#6d6560";
  theme.mesh = "#1d242c";
  theme.meshAlone = "#aab5c2";
  theme.curve = "#8fb4d9";
  theme.curveMoved = "#ff9a4d";
  theme.ghost = "#566271";
  return theme;
}

constexpr double tint = 0.22, half = 0.5;  // share of the accent in a button that is on, of the text in a ring of focus

QColor mixed(const QColor& a, const QColor& b, double share) {
  return QColor::fromRgbF(a.redF() + share * (b.redF() - a.redF()), a.greenF() + share * (b.greenF() - a.greenF()),
                          a.blueF() + share * (b.blueF() - a.blueF()));
}

/// Faint, but still to be read.
QColor disabledText(const Theme& theme) {
  return theme.line.darker(theme.kind == Theme::Kind::Light ? 125 : 60);
}

QPalette palette(const Theme& theme) {
  QPalette colors;
  colors.setColor(QPalette::Window, theme.window);
  colors.setColor(QPalette::WindowText, theme.text);
  colors.setColor(QPalette::Base, theme.panel);
  colors.setColor(QPalette::AlternateBase, theme.window);
  colors.setColor(QPalette::Text, theme.text);
  colors.setColor(QPalette::Button, theme.panel);
  colors.setColor(QPalette::ButtonText, theme.text);
  colors.setColor(QPalette::ToolTipBase, theme.panel);
  colors.setColor(QPalette::ToolTipText, theme.text);
  colors.setColor(QPalette::Highlight, theme.accent);
  colors.setColor(QPalette::HighlightedText, theme.accentText);
  colors.setColor(QPalette::Link, theme.accent);
  colors.setColor(QPalette::Mid, theme.line);
  colors.setColor(QPalette::PlaceholderText, theme.faintText);
  for (QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    colors.setColor(QPalette::Disabled, role, disabledText(theme));
  colors.setColor(QPalette::Disabled, QPalette::Light, theme.panel);  // or menus draw a shadow below such text
  return colors;
}

/// Names in @ stand for colours of the theme.
const char* const themeStyle = R"(
QMainWindow, QDialog { background: @window; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QMainWindow::separator { background: @window; width: 6px; height: 6px; }
QToolTip { color: @text; background: @panel; border: 1px solid @line; padding: 4px; }
QMenuBar { background: @window; }
QStatusBar { background: @window; color: @faint; }
QDockWidget { font-weight: 600; }
QDockWidget::title { background: @window; padding: 6px 8px; }
QFrame[card="true"] { background: @panel; border: 1px solid @line; border-radius: 6px; }
QLabel[faint="true"] { color: @faint; }
QLabel[heading="true"] { font-weight: 600; }
QTabWidget::pane { border: none; border-top: 1px solid @line; }
QTabBar::tab { padding: 5px 9px; border: none; border-bottom: 2px solid transparent; color: @faint; background: transparent; }
QTabBar#fapTabs::tab { padding: 5px 7px; }
QTabBar#workspaces::tab { padding: 4px 12px; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:focus { color: @accent; }
QPushButton { padding: 5px 10px; border: 1px solid @line; border-radius: 4px; background: @panel; }
QPushButton[compact="true"] { padding: 3px 6px; }
QPushButton:hover { border-color: @accent; }
QPushButton:checked { background: @tint; color: @text; border-color: @accent; }
QPushButton:focus { border: 2px solid @ring; padding: 4px 9px; }
QPushButton[compact="true"]:focus { padding: 2px 5px; }
QPushButton:disabled { color: @disabled; }
QToolButton { border: 1px solid transparent; border-radius: 4px; padding: 3px 5px; background: transparent; }
QToolButton[framed="true"] { border-color: @line; background: @panel; padding: 4px 6px; }
QToolButton[checkable="true"] { border-color: @line; background: @panel; }
QToolButton:hover { border-color: @line; }
QToolButton[framed="true"]:hover, QToolButton[checkable="true"]:hover { border-color: @accent; }
QToolButton[checkable="true"]:checked { background: @tint; color: @text; border-color: @accent; }
QToolButton[checkable="true"]:checked:disabled { background: @window; color: @disabled; border-color: @line; }
QToolButton:focus { border: 2px solid @ring; padding: 2px 4px; }
QToolButton[framed="true"]:focus { border: 2px solid @ring; padding: 3px 5px; }
QToolButton[checkable="true"]:focus, QToolButton[checkable="true"]:checked:focus { border: 2px solid @ring; }
QHeaderView { background: @window; }
QHeaderView::section { background: @window; border: none; border-bottom: 1px solid @line; padding: 2px 4px; }
QTableCornerButton::section { background: @window; border: none; border-bottom: 1px solid @line; }
QScrollBar { background: @window; border: none; }
QScrollBar:vertical { width: 12px; }
QScrollBar:horizontal { height: 12px; }
QScrollBar::handle { background: @edge; border-radius: 4px; margin: 2px; }
QScrollBar::handle:vertical { min-height: 24px; }
QScrollBar::handle:horizontal { min-width: 24px; }
QScrollBar::handle:hover, QScrollBar::handle:pressed { background: @faint; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; border: none; }
QScrollBar::add-page, QScrollBar::sub-page { background: @window; }
QListWidget#manualContents::item { padding: 3px 4px; }
QListWidget#plotFAPs { border: 1px solid @line; border-radius: 4px; }
QListWidget#plotFAPs::item { color: @faint; }
QListWidget#plotFAPs::item:selected { color: @text; background: @window; }
QFrame#messageBar, QFrame#recoveryBar { background: @panel; border: 1px solid @line; border-radius: 6px; }
QFrame#messageBar[severity="error"] { border-left: 4px solid @error; }
QFrame#messageBar[severity="warning"] { border-left: 4px solid @warning; }
QFrame#messageBar[severity="note"], QFrame#recoveryBar { border-left: 4px solid @accent; }
)";

QString styleSheet(const Theme& theme) {
  QString text = themeStyle;
  text.replace("@tint", mixed(theme.panel, theme.accent, tint).name());
  text.replace("@ring", mixed(theme.accent, theme.text, half).name());
  text.replace("@accentText", theme.accentText.name()).replace("@accent", theme.accent.name());
  text.replace("@window", theme.window.name()).replace("@panel", theme.panel.name());
  text.replace("@text", theme.text.name()).replace("@faint", theme.faintText.name());
  text.replace("@edge", theme.edge.name());
  text.replace("@line", theme.line.name()).replace("@error", theme.error.name());
  return text.replace("@warning", theme.warning.name()).replace("@disabled", disabledText(theme).name());
}

}  // namespace

const Theme& Theme::of(Kind kind) {
  static const Theme lightTheme = light(), darkTheme = dark();
  return kind == Kind::Light ? lightTheme : darkTheme;
}

const Theme& Theme::current() {
  return applied ? *applied : of(Kind::Light);
}

Theme::Kind Theme::preferred(const QApplication& application) {
  const bool isDark = application.palette().color(QPalette::Window).lightness() < middleGrey;
  return Remembered::value(darkKey, isDark).toBool() ? Kind::Dark : Kind::Light;
}

void Theme::choose(Kind kind, QApplication& application) {
  Remembered::set(darkKey, kind == Kind::Dark);
  apply(kind, application);
}

void Theme::apply(Kind kind, QApplication& application) {
  applied = &of(kind);
  application.setStyle(new StudioStyle);
  application.setPalette(palette(*applied));
  application.setStyleSheet(styleSheet(*applied));
}

BorrowedTheme::BorrowedTheme(const Theme& theme) : before_(applied) {
  applied = &theme;
}

BorrowedTheme::~BorrowedTheme() {
  applied = before_;
}

}  // namespace mien
