#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QProgressBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>

#include "FaceModel.h"
#include "FaceStateText.h"
#include "FaceTexture.h"
#include "PictureLabel.h"
#include "StudioFixture.h"
#include "TexturePanel.h"
#include "WarpMeshView.h"

namespace {

const QString painted = QString(MIEN_TEST_DIR) + "/../data/textures/painted.png";
const QString paintedMesh = QString(MIEN_TEST_DIR) + "/../data/textures/painted_7x7.csv";
const QString foldedMesh = QString(MIEN_TEST_DIR) + "/data/malformed/warp_mesh/line6_folded_columns.csv";
constexpr int wholeWidth = 2048;
const mien::MeshNode nose{3, 3};

class TexturePanel : public StudioFixture {
 protected:
  TexturePanel() {
    find<QAction>("textureDockAction")->trigger();
    settle();
    mesh = find<mien::WarpMeshView>("textureMesh");
    warped = find<mien::PictureLabel>("textureWarped");
    panel = find<mien::TexturePanel>("texturePanel");
  }

  const mien::FaceState& state() { return window->model().state(); }
  QString meshFile() { return QString::fromStdString(state().textureMesh); }
  QImage face() {
    settle();
    return find<QWidget>("faceView")->grab().toImage();
  }
  bool isWhole() { return warped->picture().width() == wholeWidth && !find<QWidget>("textureCancel")->isVisible(); }
  bool waitForWhole() {
    return waitUntil([this] { return isWhole(); }, 20000);
  }
  void openPainted() {
    QTest::mouseClick(find<QToolButton>("texturePainted"), Qt::LeftButton);
    ASSERT_TRUE(waitForWhole());
    QApplication::processEvents();
  }
  void drag(mien::MeshNode node, const QPoint& by) { StudioFixture::drag(mesh, mesh->pixelOf(node).toPoint(), by); }
  mien::WarpMesh stored() {
    mien::WarpMesh read;
    EXPECT_EQ(mien::readSourceMesh(state().textureMesh, read), "");
    return read;
  }
  QString status() { return find<QLabel>("textureStatus")->text(); }

  mien::WarpMeshView* mesh;
  mien::PictureLabel* warped;
  mien::TexturePanel* panel;
  QTemporaryDir folder;
};

TEST_F(TexturePanel, ThePaintedFaceDressesTheSkinAndStandsInTheState) {
  const QImage skin = face();
  openPainted();
  EXPECT_NE(face(), skin);
  EXPECT_EQ(QFileInfo(QString::fromStdString(state().texture)).fileName(), "painted.png");
  mien::FaceState read;
  EXPECT_EQ(mien::readFaceState(mien::writeFaceState(state()), read), "");
  EXPECT_TRUE(read == state());
  EXPECT_EQ(message(), "");
}

TEST_F(TexturePanel, WithoutAPhotographItSaysHowToGetOne) {
  EXPECT_TRUE(find<QWidget>("textureEmpty")->isVisible());
  EXPECT_TRUE(find<QToolButton>("textureEmptyOpen")->isVisible());
  EXPECT_FALSE(mesh->isVisible());
  QTest::mouseClick(find<QToolButton>("textureEmptyPainted"), Qt::LeftButton);
  ASSERT_TRUE(waitForWhole());
  EXPECT_TRUE(mesh->isVisible());
  EXPECT_FALSE(find<QWidget>("textureEmpty")->isVisible());
  for (const auto& [name, words] :
       {std::pair("textureMeshName", "Photograph"), std::pair("textureWarpedName", "Texture, as the face wears it")}) {
    EXPECT_TRUE(find<QLabel>(name)->isVisible());
    EXPECT_EQ(find<QLabel>(name)->text(), words);
  }
}

TEST_F(TexturePanel, TheStateAloneDressesTheFace) {
  window->model().change([](mien::FaceState& state) {
    state.texture = painted.toStdString();
    state.textureMesh = paintedMesh.toStdString();
  });
  ASSERT_TRUE(waitForWhole());
  EXPECT_TRUE(find<mien::FaceView>("faceView")->isTextured());
  EXPECT_TRUE(find<QCheckBox>("textureOn")->isChecked());
  window->model().change([](mien::FaceState& state) { state.texture.clear(); });
  settle();
  EXPECT_FALSE(find<mien::FaceView>("faceView")->isTextured());
  EXPECT_FALSE(find<QCheckBox>("textureOn")->isChecked());
}

TEST_F(TexturePanel, ADraggedPointMovesTheMeshAndTheFace) {
  openPainted();
  find<QCheckBox>("textureMirror")->setChecked(false);
  const QImage before = face(), texture = warped->picture();
  const mien::WarpMesh from = stored();
  const double scale = (mesh->pixelOf({3, 4}).x() - mesh->pixelOf(nose).x()) / (from.x(3, 4) - from.x(3, 3));
  drag(nose, QPoint(8, -6));
  ASSERT_TRUE(waitForWhole());
  const mien::WarpMesh to = stored();
  EXPECT_NEAR(to.x(3, 3) - from.x(3, 3), 8.0 / scale, 1e-6);
  EXPECT_NEAR(to.y(3, 3) - from.y(3, 3), -6.0 / scale, 1e-6);
  EXPECT_EQ((to.x.array() != from.x.array()).count(), 1);
  EXPECT_TRUE(waitUntil([&] { return warped->picture() != texture; }));
  EXPECT_NE(face(), before);
}

TEST_F(TexturePanel, ArrowKeysMoveByPixelsAndTabGoesFromPointToPoint) {
  openPainted();
  const mien::WarpMesh from = stored();
  mesh->setFocus();
  mesh->choose({3, 2});
  QTest::keyClick(mesh, Qt::Key_Right);
  QTest::keyClick(mesh, Qt::Key_Down, Qt::ShiftModifier);
  mien::WarpMesh to = stored();
  EXPECT_NEAR(to.x(3, 2) - from.x(3, 2), 1.0, 1e-9);
  EXPECT_NEAR(to.y(3, 2) - from.y(3, 2), 10.0, 1e-9);
  EXPECT_NEAR(to.x(3, 4) - from.x(3, 4), -1.0, 1e-9);  // the mirror image
  EXPECT_NEAR(to.y(3, 4) - from.y(3, 4), 10.0, 1e-9);
  EXPECT_TRUE(status().contains(QString::number(to.x(3, 2), 'f', 1))) << status().toStdString();
  QTest::keyClick(mesh, Qt::Key_Tab);
  EXPECT_EQ(mesh->chosen(), (mien::MeshNode{3, 3}));
  QTest::keyClick(mesh, Qt::Key_Backtab);
  EXPECT_EQ(mesh->chosen(), (mien::MeshNode{3, 2}));
  QTest::mouseClick(find<QToolButton>("textureUndo"), Qt::LeftButton);
  EXPECT_NEAR(stored().y(3, 2), from.y(3, 2), 1e-9);
  EXPECT_NEAR(stored().x(3, 2) - from.x(3, 2), 1.0, 1e-9);
  QTest::mouseClick(find<QToolButton>("textureReset"), Qt::LeftButton);
  EXPECT_TRUE(stored() == from);
  EXPECT_FALSE(find<QToolButton>("textureUndo")->isEnabled());
}

TEST_F(TexturePanel, AFoldIsRefusedAndNamed) {
  openPainted();
  const mien::WarpMesh from = stored();
  const QPoint there = mesh->pixelOf({3, 5}).toPoint() - mesh->pixelOf(nose).toPoint();
  const QPoint start = mesh->pixelOf(nose).toPoint();
  QTest::mousePress(mesh, Qt::LeftButton, Qt::NoModifier, start);
  dragTo(mesh, start + there);
  EXPECT_TRUE(status().contains("columns 4 and 5 cross in row 4")) << status().toStdString();
  QTest::mouseRelease(mesh, Qt::LeftButton, Qt::NoModifier, start + there);
  EXPECT_TRUE(stored() == from);
  panel->open(foldedMesh);
  EXPECT_TRUE(message().contains("line6_folded_columns.csv:6")) << message().toStdString();
  EXPECT_TRUE(stored() == from);
}

TEST_F(TexturePanel, APhotographWithoutAMeshGetsOneToBeMoved) {
  const QString name = folder.filePath("anna.png");
  ASSERT_TRUE(QFile::copy(painted, name));
  panel->open(name);
  ASSERT_TRUE(waitForWhole());
  EXPECT_TRUE(message().contains("anna.png has no mesh")) << message().toStdString();
  EXPECT_EQ(stored().rows(), 7);
  EXPECT_GT(stored().x.minCoeff(), 0.0);
  const auto isToldUnsaved = [&] { return find<QLabel>("textureStatus")->text().contains("in no file"); };
  EXPECT_TRUE(isToldUnsaved());
  EXPECT_TRUE(panel->save(folder.filePath("anna.csv")));
  EXPECT_EQ(meshFile(), folder.filePath("anna.csv"));
  EXPECT_FALSE(isToldUnsaved());
  const mien::WarpMesh saved = stored();
  find<QCheckBox>("textureOn")->setChecked(false);
  settle();
  EXPECT_EQ(state().texture, "");
  EXPECT_FALSE(find<mien::FaceView>("faceView")->isTextured());
  find<QCheckBox>("textureOn")->setChecked(true);
  ASSERT_TRUE(waitUntil([&] { return find<mien::FaceView>("faceView")->isTextured(); }));
  EXPECT_TRUE(stored() == saved);
  EXPECT_FALSE(panel->save(folder.filePath("there_is_no_folder/x.csv")));
  EXPECT_TRUE(message().contains("there_is_no_folder"));
}

/// As when another colouring is chosen: what is ticked is what is seen.
TEST_F(TexturePanel, ColoursOfADockGiveWayToAPhotograph) {
  const auto colours = [this] { return find<QComboBox>("colorBy")->currentText(); };
  find<QAction>("continuityDockAction")->trigger();
  auto* map = find<QComboBox>("continuityFace");
  map->setCurrentIndex(2);
  settle();
  ASSERT_TRUE(colours().contains("Continuity dock")) << colours().toStdString();
  find<QAction>("textureDockAction")->trigger();
  openPainted();
  EXPECT_EQ(colours(), "Photograph");
  EXPECT_EQ(map->currentIndex(), 0);
  auto* on = find<QCheckBox>("textureOn");
  on->setChecked(false);
  map->setCurrentIndex(2);
  settle();
  on->setChecked(true);
  EXPECT_TRUE(waitUntil([&] { return colours() == "Photograph"; })) << colours().toStdString();
}

TEST_F(TexturePanel, ColoursStayWhenThePhotographCannotBeRead) {
  find<QComboBox>("colorBy")->setCurrentText("Patches");
  panel->open(folder.filePath("no.png"));
  ASSERT_TRUE(waitUntil([&] { return message().contains("no.png"); }));
  EXPECT_EQ(find<QComboBox>("colorBy")->currentText(), "Patches");
}

TEST_F(TexturePanel, LandmarksGiveTheMeshCoarseOrFine) {
  openPainted();
  const mien::WarpMesh from = stored();
  QFile file(folder.filePath("landmarks.csv"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("landmark,x,y\n");
  for (size_t i = 0; i < from.names.size(); ++i)
    if (!from.names[i].empty())
      file.write(QString("%1,%2,%3\n")
                     .arg(QString::fromStdString(from.names[i]))
                     .arg(from.x(i / 7, i % 7), 0, 'g', 17)
                     .arg(from.y(i / 7, i % 7), 0, 'g', 17)
                     .toUtf8());
  file.close();
  panel->open(file.fileName());
  EXPECT_EQ(stored().rows(), 7);
  EXPECT_LT((stored().x - from.x).block(1, 1, 5, 5).cwiseAbs().maxCoeff(), 0.1);
  find<QCheckBox>("textureFine")->setChecked(true);
  EXPECT_EQ(stored().rows(), 19);
  EXPECT_TRUE(waitForWhole());
}

TEST_F(TexturePanel, AFileWithAFaultLeavesFaceAndStateAndSaysWhich) {
  openPainted();
  const mien::FaceState before = state();
  const QString name = folder.filePath("no.png");
  QFile file(name);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is no picture");
  file.close();
  panel->open(name);
  ASSERT_TRUE(waitUntil([&] { return message().contains("no.png"); }));
  settle();
  EXPECT_TRUE(state() == before);
  EXPECT_TRUE(message().contains("no.png"));
  EXPECT_TRUE(find<mien::FaceView>("faceView")->isTextured());
}

class LargePhotograph : public TexturePanel {
 protected:
  LargePhotograph() : name(folder.filePath("large.jpg")) {
    QImage image(6000, 8000, QImage::Format_RGB32);
    image.fill(QColor(200, 150, 120));
    image.save(name, "JPG");
  }
  QString name;
};

TEST_F(LargePhotograph, OpeningCanBeCancelled) {
  openPainted();
  const mien::FaceState before = state();
  panel->open(name);
  auto* cancel = find<QToolButton>("textureCancel");
  ASSERT_TRUE(waitUntil([&] { return cancel->isVisible(); }));
  QTest::mouseClick(cancel, Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return !cancel->isVisible(); }, 20000));
  EXPECT_TRUE(state() == before);
  EXPECT_EQ(warped->picture().width(), wholeWidth);
  EXPECT_EQ(message(), "");
}

TEST_F(LargePhotograph, TheWindowCanBeClosedMeanwhile) {
  panel->open(name);
  ASSERT_TRUE(waitUntil([&] { return find<QWidget>("textureProgress")->isVisible(); }));
  window->close();
}

TEST_F(TexturePanel, ADroppedPhotographIsOpened) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(painted)});
  QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(panel, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(panel, &drop);
  EXPECT_EQ(state().texture, painted.toStdString());
  EXPECT_TRUE(waitForWhole());
}

TEST_F(TexturePanel, EveryControlIsNamedExplainedAndReachedByKeyboard) {
  for (const char* name :
       {"textureOpen", "texturePainted", "textureOn", "textureOpenMesh", "textureFine", "textureMirror", "textureUndo",
        "textureReset", "textureSave", "textureCancel", "textureMesh"}) {
    auto* control = find<QWidget>(name);
    EXPECT_FALSE(control->toolTip().isEmpty()) << name;
    EXPECT_TRUE(control->focusPolicy() & Qt::TabFocus) << name;
  }
}

}  // namespace
