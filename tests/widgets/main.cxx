#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QSurfaceFormat>

#include "Theme.h"

#ifdef __SANITIZE_ADDRESS__
/// Libraries that are unloaded before leaks are counted would be unknown, and so could not be told from ours.
extern "C" int dlclose(void*) {
  return 0;
}
#endif

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  mien::Theme::apply(mien::Theme::Kind::Light, application);
  return RUN_ALL_TESTS();
}
