#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QTimer>
#include <QToolButton>

#include "FaceModel.h"
#include "FacePhotograph.h"
#include "FaceTexture.h"
#include "FaceView.h"
#include "Session.h"
#include "SessionFixture.h"
#include "TexturePanel.h"
#include "WarpMeshView.h"

namespace {

const mien::MeshNode noseNode{3, 3};

/// A mesh over a photograph that was moved by hand and is in no file: sessions, undo and commands carry it.
class TextureSession : public SessionFixture {
 protected:
  mien::WarpMeshView* mesh() { return find<mien::WarpMeshView>("textureMesh"); }
  const mien::WarpMesh& shown() { return window->findChild<mien::FacePhotograph*>()->mesh(); }
  const mien::FaceState& state() { return window->model().state(); }
  mien::WarpMesh stored() {
    mien::WarpMesh read;
    EXPECT_EQ(mien::readSourceMesh(state().textureMesh, read), "");
    return read;
  }
  bool waitForTexture() {
    return waitUntil([this] {
      return find<mien::FaceView>("faceView")->isTextured() && !find<QWidget>("textureCancel")->isVisible();
    });
  }
  void moveTheNose() {
    drag(mesh(), mesh()->pixelOf(noseNode).toPoint(), {6, 4});
    ASSERT_TRUE(waitForTexture());
    settle();
  }
  void openPaintedAndMove() {
    find<QAction>("textureDockAction")->trigger();
    settle();
    QTest::mouseClick(find<QToolButton>("texturePainted"), Qt::LeftButton);
    ASSERT_TRUE(waitForTexture());
    opened = stored();
    moveTheNose();
    moved = stored();
    ASSERT_FALSE(moved == opened);
  }
  void openANewWindow() {
    window = std::make_unique<mien::StudioWindow>();
    window->show();
    settle();
  }
  void expectMoved(const mien::FaceState& before) {
    ASSERT_TRUE(waitForTexture());
    EXPECT_EQ(state(), before);
    EXPECT_TRUE(shown() == moved);
    EXPECT_FALSE(message().contains("Left out")) << message().toStdString();
  }

  mien::WarpMesh opened, moved;
};

TEST_F(TextureSession, AMovedMeshComesBackWithTheSession) {
  openPaintedAndMove();
  const mien::FaceState before = state();
  reopen();
  expectMoved(before);
  EXPECT_FALSE(window->document().isModified());
}

TEST_F(TextureSession, AMovedMeshComesBackAfterACrash) {
  openPaintedAndMove();
  const mien::FaceState before = state();
  const nlohmann::json kept = find<mien::Session>("session")->whole();
  openANewWindow();
  ASSERT_TRUE(window->document().recover(kept, QString()));
  settle();
  expectMoved(before);
}

TEST_F(TextureSession, UndoAndRedoGiveTheVeryMesh) {
  openPaintedAndMove();
  const mien::FaceState before = state();
  find<QAction>("actionUndo")->trigger();
  ASSERT_TRUE(waitUntil([&] { return shown() == opened; }));
  EXPECT_TRUE(stored() == opened);
  find<QAction>("actionRedo")->trigger();
  ASSERT_TRUE(waitUntil([&] { return shown() == moved; }));
  EXPECT_EQ(state(), before);
}

TEST_F(TextureSession, NamesTheFileOnceTheMeshIsSaved) {
  openPaintedAndMove();
  ASSERT_TRUE(find<mien::TexturePanel>("texturePanel")->save(file("mine.csv")));
  EXPECT_EQ(state().textureMesh, file("mine.csv").toStdString());
  reopen();
  ASSERT_TRUE(waitForTexture());
  EXPECT_EQ(state().textureMesh, file("mine.csv").toStdString());
  EXPECT_TRUE(shown() == moved);
  moveTheNose();
  EXPECT_FALSE(stored() == moved);
  EXPECT_NE(state().textureMesh, file("mine.csv").toStdString()) << "the file is the mesh no more";
}

TEST_F(TextureSession, ACommandCarriesTheMesh) {
  openPaintedAndMove();
  find<QAction>("actionCopyCommand")->trigger();
  const QString command = QGuiApplication::clipboard()->text();
  EXPECT_TRUE(command.contains("mien_warp_mesh,1,")) << command.toStdString();
  EXPECT_FALSE(command.contains(QDir::tempPath())) << command.toStdString();
}

/// The session's own question is the only one, and what it holds is not lost.
TEST_F(TextureSession, ClosingAsksOnceAndOnlyForWhatWouldBeLost) {
  using Answer = mien::SessionDocument::Answer;
  int asked = 0, dialogs = 0;
  openPaintedAndMove();
  window->document().setQuestion([&] { return ++asked, Answer::Cancel; });
  const auto close = [&] {
    QTimer::singleShot(0, window.get(), [&dialogs] {
      QWidget* dialog = QApplication::activeModalWidget();
      dialogs += dialog != nullptr;
      if (dialog) dialog->close();
    });
    const bool closed = window->close();
    QApplication::processEvents();
    return closed;
  };
  EXPECT_FALSE(close());
  EXPECT_EQ(asked, 1);
  ASSERT_TRUE(window->document().save(file("all" + QString(mien::SessionFile::ending))));
  EXPECT_TRUE(close());
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(dialogs, 0);
}

}  // namespace
