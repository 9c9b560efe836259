#include "FileDialog.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "SessionDocument.h"
#include "StudioFixture.h"

namespace {

using FileDialogs = StudioFixture;

TEST_F(FileDialogs, BeginWhereAFileWasOpenedOrSavedLast) {
  const QString first = writeLids(3, 25);
  ASSERT_TRUE(window->openFile(first));
  EXPECT_EQ(mien::FileDialog::beside("joy.svg"), QFileInfo(first).absoluteDir().filePath("joy.svg"));
  QTemporaryDir folder;
  ASSERT_TRUE(window->document().save(folder.filePath("face.mien-session.json")));
  EXPECT_EQ(mien::FileDialog::beside("joy.svg"), folder.filePath("joy.svg"));
  EXPECT_EQ(mien::FileDialog::beside(QString()), folder.path());
  EXPECT_EQ(mien::FileDialog::beside("/own/joy.svg"), "/own/joy.svg");
  ASSERT_TRUE(folder.remove());
  EXPECT_EQ(mien::FileDialog::beside("joy.svg"), "joy.svg") << "a folder that is gone";
}

TEST_F(FileDialogs, WhatIsNotThereOrAFolderIsSaidSoWhateverItsEnding) {
  QTemporaryDir folder;
  for (const char* name : {"nothere.ply", "nothere.fap", "nothere.json"}) {
    EXPECT_FALSE(window->openFile(folder.filePath(name)));
    EXPECT_EQ(message(), QString("There is no file %1; it was moved, or has another name.").arg(name));
  }
  ASSERT_TRUE(QDir(folder.path()).mkdir("dir.ply"));
  EXPECT_FALSE(window->openFile(folder.filePath("dir.ply")));
  EXPECT_EQ(message(), QString("dir.ply is a folder; open a file in it."));
}

}  // namespace
