#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QWidget>
#include <memory>
#include <nlohmann/json.hpp>

#include "SessionDocument.h"
#include "SessionFile.h"
#include "StudioFixture.h"
#include "StudioWindow.h"
#include "WidgetSettings.h"

/// A Studio window and a folder for its sessions.
class SessionFixture : public StudioFixture {
 protected:
  QString file(const QString& name) const { return folder.filePath(name); }
  nlohmann::json settings() { return mien::WidgetSettings::read(*window, mien::WidgetSettings::Of::Session); }

  /// Saves the window, and opens that in a new one.
  void reopen() {
    const QString session = file("all" + QString(mien::SessionFile::ending));
    ASSERT_TRUE(window->document().save(session));
    window = std::make_unique<mien::StudioWindow>();
    for (const char* view : {"faceView", "curveView"}) find<QWidget>(view)->setUpdatesEnabled(false);
    window->show();
    settle();
    ASSERT_TRUE(window->document().open(session)) << message().toStdString();
    settle();
  }

  QTemporaryDir folder;
};
