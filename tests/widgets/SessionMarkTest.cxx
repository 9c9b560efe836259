#include <gtest/gtest.h>
#include <vtkCamera.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "FaceModel.h"
#include "FaceView.h"
#include "History.h"
#include "ReferenceData.h"
#include "ScanPanel.h"
#include "SessionDocument.h"
#include "SessionFile.h"
#include "SessionFixture.h"
#include "WidgetSettings.h"

namespace {

using json = nlohmann::json;
using mien::FaceState;
using mien::WidgetSettings;

/// What marks a session as changed, and what comes back with it that is no setting of a widget.
class SessionMark : public SessionFixture {};

/// By hand, as a user chooses: in the list that opens, or with keys.
TEST_F(SessionMark, AColourThatIsChosenIsAStep) {
  auto* colors = find<QComboBox>("colorBy");
  int row = -1;
  for (int i = 0; i < colors->count(); ++i)
    if (colors->itemText(i).startsWith("Mean curvature")) row = i;
  ASSERT_GE(row, 0);
  QTest::mouseClick(colors, Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return colors->view()->isVisible(); }));
  settle();
  QTest::qWait(600);  // a list that has just opened takes no release
  const QModelIndex item = colors->model()->index(row, 0);
  colors->view()->scrollTo(item);
  QTest::mouseClick(colors->view()->viewport(), Qt::LeftButton, Qt::NoModifier,
                    colors->view()->visualRect(item).center());
  QTest::qWait(600);
  EXPECT_TRUE(colors->currentText().startsWith("Mean curvature")) << colors->currentText().toStdString();
  EXPECT_EQ(window->history().count(), 1);
  EXPECT_TRUE(window->isWindowModified());
  window->history().undo();
  EXPECT_EQ(colors->currentText(), "Skin");
  EXPECT_FALSE(window->isWindowModified());
  window->history().redo();
  EXPECT_TRUE(colors->currentText().startsWith("Mean curvature"));
  window->history().undo();
  colors->setFocus();
  QTest::keyClick(colors, Qt::Key_M);
  QTest::qWait(600);
  EXPECT_TRUE(colors->currentText().startsWith("Mean curvature")) << colors->currentText().toStdString();
  EXPECT_EQ(window->history().count(), 1);
  window->history().undo();
  EXPECT_EQ(colors->currentText(), "Skin");
  settle();
  colors->setCurrentIndex(row);  // long after the last event
  settle();
  EXPECT_EQ(window->history().count(), 1);
  EXPECT_TRUE(window->isWindowModified());
  window->history().undo();
  EXPECT_EQ(colors->currentText(), "Skin");
}

/// As the desktop's dialog for files, a child of the window with input widgets of its own.
TEST_F(SessionMark, ADialogThatComesAndGoesChangesNothing) {
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  const json before = settings();
  QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
  settle();
  auto dialog = std::make_unique<QFileDialog>(window.get());
  dialog->setOption(QFileDialog::DontUseNativeDialog);
  dialog->show();
  ASSERT_GT(dialog->findChildren<QLineEdit*>().size(), 0);
  settle();
  EXPECT_EQ(json::diff(before, settings()).dump(), "[]");
  QTest::keyClick(dialog.get(), Qt::Key_Escape);
  settle();
  dialog.reset();
  settle();
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_EQ(window->history().count(), 0);
}

TEST_F(SessionMark, SavingTakesWhatHasJustChangedWithIt) {
  QTest::keyClick(find<QComboBox>("faceMesh"), Qt::Key_Down);
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  settle();
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_EQ(window->history().count(), 1);
}

TEST_F(SessionMark, IsMarkedAsChangedWhenTheCameraIsMoved) {
  int asked = 0;
  window->document().setQuestion([&] { return ++asked, mien::SessionDocument::Answer::Discard; });
  auto* view = find<mien::FaceView>("faceView");
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  QTest::keyClick(view, Qt::Key_Left);
  settle();
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_EQ(window->history().count(), 0);
  EXPECT_TRUE(window->document().mayClose());
  EXPECT_EQ(asked, 1);
  QTest::keyClick(view, Qt::Key_Home);
  settle();
  EXPECT_FALSE(window->isWindowModified()) << "as it was saved";
  QTest::keyClick(view, Qt::Key_Right);
  settle();
  ASSERT_TRUE(window->document().save());
  EXPECT_FALSE(window->isWindowModified());
  reopen();
  EXPECT_FALSE(window->isWindowModified());
  window->resize(window->size() - QSize(40, 40));
  settle();
  EXPECT_FALSE(window->isWindowModified());
}

TEST_F(SessionMark, BringsBackTheViewOfAScan) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  const auto isMeasured = [this] {
    auto* panel = find<mien::ScanPanel>("scanPanel");
    return waitUntil([panel] { return panel->hasScan() && !panel->isMeasuring(); }, 120000);
  };
  const auto cameraOf = [this] {
    vtkCamera* camera = find<mien::FaceView>("faceView")->camera();
    std::vector<double> all(6);
    camera->GetPosition(all.data());
    camera->GetFocalPoint(all.data() + 3);
    return all;
  };
  auto* panel = find<mien::ScanPanel>("scanPanel");
  panel->openLandmarks(QString::fromStdString(referencePath("heads/landmarks68.csv")));
  panel->open(QString::fromStdString(referencePath("heads/subject01_neutral.ply")));
  ASSERT_TRUE(isMeasured()) << message().toStdString();
  settle();
  const std::vector<double> before = cameraOf();
  reopen();
  ASSERT_TRUE(isMeasured()) << message().toStdString();
  settle();
  const std::vector<double> after = cameraOf();
  for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-6) << i;
  EXPECT_FALSE(window->isWindowModified());
}

/// Whatever was shown before a state, its movement has the same colours.
TEST_F(SessionMark, TheRangeOfTheCurvesBelongsToWhatIsShown) {
  const auto range = [this] { return find<QDoubleSpinBox>("curveRange")->text().toStdString(); };
  const auto move = [this](double value) {
    QTest::mouseClick(find<QWidget>("fapHeading8"), Qt::LeftButton);
    window->model().change([value](FaceState& state) { state.fapValues[3] = value; });
    settle();
  };
  move(300.0);
  const std::string little = range();
  move(1000.0);
  ASSERT_NE(range(), little);
  window->history().undo();
  settle();
  EXPECT_EQ(range(), little);
  ASSERT_TRUE(window->openFile(writeLids(60, 25.0)));
  settle();
  const std::string atTheBegin = range();
  for (int frame = 0; frame < 60; ++frame) {
    window->model().showFrame(frame);
    ASSERT_TRUE(window->model().update());
    EXPECT_EQ(range(), atTheBegin) << frame;
  }
  window->model().showFrame(3);
  settle();
  reopen();
  EXPECT_EQ(range(), atTheBegin);
}

}  // namespace
