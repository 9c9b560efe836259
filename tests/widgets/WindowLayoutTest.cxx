#include <gtest/gtest.h>

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "StudioWindow.h"

namespace {

class WindowLayout : public testing::Test {
 protected:
  WindowLayout() {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName("mien-test");
  }
  ~WindowLayout() override { QCoreApplication::setOrganizationName(QString()); }

  static QDockWidget* dock(mien::StudioWindow& window) { return window.findChild<QDockWidget*>("spectrumDock"); }

  QTemporaryDir folder;
};

TEST_F(WindowLayout, DocksComeBackWhereTheyWere) {
  {
    mien::StudioWindow window;
    window.show();
    EXPECT_FALSE(dock(window)->isVisible());
    window.findChild<QAction*>("spectrumDockAction")->trigger();
    window.addDockWidget(Qt::RightDockWidgetArea, dock(window));
    window.close();
  }
  mien::StudioWindow window;
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  EXPECT_TRUE(dock(window)->isVisible());
  EXPECT_EQ(window.dockWidgetArea(dock(window)), Qt::RightDockWidgetArea);
}

}  // namespace
