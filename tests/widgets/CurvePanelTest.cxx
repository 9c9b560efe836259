#include <gtest/gtest.h>
#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QSpinBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <cmath>

#include "BoundaryCurveData.h"
#include "CurveHandle.h"
#include "CurvePanel.h"
#include "FaceModel.h"
#include "History.h"
#include "StudioFixture.h"

namespace {

class CurvePanel : public StudioFixture {
 protected:
  CurvePanel() {
    find<QAction>("curvesDockAction")->trigger();
    settle();
  }

  const std::vector<mien::CurveEdit>& edits() { return window->model().state().edits; }
  mien::FaceCurves face() {
    settle();
    mien::FaceCurves read;
    auto* curves = vtkPolyData::SafeDownCast(window->model().pipeline().curves()->GetOutputDataObject(0));
    EXPECT_EQ(mien::readFaceCurves(curves, read), "");
    return read;
  }
  void click(const char* name) { QTest::mouseClick(find<QToolButton>(name), Qt::LeftButton); }

  /// C15 at a place beside the middle, by so many mm up.
  void raise(double millimetres) {
    find<QComboBox>("curveCurve")->setCurrentText("C15");
    find<QSpinBox>("curvePoint")->setValue(24);
    auto* up = find<QDoubleSpinBox>("curveDy");
    up->setFocus();
    up->selectAll();
    QTest::keyClicks(up, QString::number(millimetres));
    QTest::keyClick(up, Qt::Key_Return);
    click("curveApply");
  }
};

TEST_F(CurvePanel, APointMovesByWhatWasAskedAndItsMirrorImageToo) {
  const mien::FaceCurves before = face();
  raise(1.5);
  ASSERT_EQ(edits().size(), 1u);
  EXPECT_EQ(find<QListWidget>("curveEdits")->count(), 1);
  const mien::FaceCurves after = face();
  EXPECT_NEAR(after.curves.curve(14)(24, 1) - before.curves.curve(14)(24, 1), 1.5, 1e-9);
  EXPECT_NEAR(after.curves.curve(14)(16, 1) - before.curves.curve(14)(16, 1), 1.5, 1e-9);
  EXPECT_EQ(after.curves.curve(0), before.curves.curve(0));
  EXPECT_EQ(message(), "");
}

TEST_F(CurvePanel, WithoutMirrorTheOtherSideStays) {
  const mien::FaceCurves before = face();
  find<QCheckBox>("curveMirror")->setChecked(false);
  raise(1.0);
  const mien::FaceCurves after = face();
  EXPECT_EQ(after.curves.curve(14).row(16), before.curves.curve(14).row(16));
  EXPECT_FALSE(edits().front().mirrored);
}

TEST_F(CurvePanel, AnEmptyListSaysWhatToDo) {
  auto* hint = find<QLabel>("curveHint");
  EXPECT_TRUE(hint->isVisible());
  raise(1.0);
  EXPECT_FALSE(hint->isVisible());
  click("curveUndo");
  EXPECT_TRUE(hint->isVisible());
}

TEST_F(CurvePanel, TheDockFitsIntoASmallWindow) {
  for (int tab = 0; tab < 2; ++tab) {  // 1280 pixels less the panels at the left
    find<QTabWidget>("curveTabs")->setCurrentIndex(tab);
    settle();
    EXPECT_LE(find<mien::CurvePanel>("curvePanel")->minimumSizeHint().width(), 900) << tab;
  }
}

TEST_F(CurvePanel, DraggingEndsWhereItsNumbersAreNotSeen) {
  auto* drag = find<QToolButton>("curveDrag");
  drag->setChecked(true);
  find<QTabWidget>("curveTabs")->setCurrentIndex(1);
  EXPECT_FALSE(drag->isChecked());
}

TEST_F(CurvePanel, UndoAndRemoveTakeMovesBack) {
  const mien::FaceCurves before = face();
  raise(1.0);
  raise(-0.5);
  auto* list = find<QListWidget>("curveEdits");
  ASSERT_EQ(list->count(), 2);
  list->setCurrentRow(0);
  click("curveRemove");
  ASSERT_EQ(edits().size(), 1u);
  EXPECT_DOUBLE_EQ(edits().front().move.y(), -0.5);
  click("curveUndo");
  EXPECT_TRUE(edits().empty());
  EXPECT_EQ(face().curves.points, before.curves.points);
  EXPECT_FALSE(find<QToolButton>("curveUndo")->isEnabled());
}

TEST_F(CurvePanel, CurvesThatWouldCrossAreRefusedAndNamed) {
  const mien::FaceCurves before = face();
  raise(60.0);
  EXPECT_TRUE(edits().empty());
  EXPECT_TRUE(message().contains("C15")) << message().toStdString();
  EXPECT_EQ(face().curves.points, before.curves.points);
  EXPECT_EQ(find<QListWidget>("curveEdits")->count(), 0);
}

/// Handles in the view of the curves, which must have been drawn for its pixels to be known.
class CurveDrag : public CurvePanel {
 protected:
  CurveDrag() {
    drawViews();
    view = find<QWidget>("curveView");
    handle = find<mien::CurvePanel>("curvePanel")->findChild<mien::CurveHandle*>();
    find<QToolButton>("curveDrag")->setChecked(true);
  }

  void grab(int curve, int point) {
    start = handle->pixelOf(curve, point).toPoint();
    QTest::mousePress(view, Qt::LeftButton, {}, start);
  }
  void drag(int right, int down) { dragTo(view, start + QPoint(right, down)); }
  void release(int right, int down) { QTest::mouseRelease(view, Qt::LeftButton, {}, start + QPoint(right, down)); }

  QWidget* view = nullptr;
  mien::CurveHandle* handle = nullptr;
  QPoint start;
};

TEST_F(CurveDrag, ADragIsTheEditOfTheSameNumbers) {
  const mien::FaceCurves before = face();
  grab(14, 24);
  EXPECT_EQ(handle->name(), QString("C15, v 216.0\u00b0"));
  drag(1, -1);
  drag(2, -3);
  const mien::FaceCurves during = face();
  ASSERT_EQ(edits().size(), 1u);
  release(2, -3);
  ASSERT_EQ(edits().size(), 1u) << "one step of undo";
  const mien::CurveEdit dragged = edits().front();
  EXPECT_GT(dragged.move.x(), 0.2);
  EXPECT_GT(dragged.move.y(), dragged.move.x());
  EXPECT_EQ(dragged.move.z(), 0.0) << "in the plane of the view from the front";
  EXPECT_LT((during.curves.curve(14).row(24) - before.curves.curve(14).row(24) - dragged.move.transpose()).norm(),
            1e-9);
  click("curveUndo");
  EXPECT_EQ(face().curves.points, before.curves.points);
  find<QComboBox>("curveCurve")->setCurrentText("C15");
  find<QSpinBox>("curvePoint")->setValue(24);
  find<QDoubleSpinBox>("curveDx")->setValue(dragged.move.x());
  find<QDoubleSpinBox>("curveDy")->setValue(dragged.move.y());
  find<QDoubleSpinBox>("curveDz")->setValue(0.0);
  click("curveApply");
  ASSERT_EQ(edits().size(), 1u);
  EXPECT_TRUE(edits().front() == dragged);
  EXPECT_EQ(face().curves.points, during.curves.points);
}

TEST_F(CurveDrag, IsOneStepOfTheHistory) {
  const mien::FaceCurves before = face();
  window->history().clear();
  grab(14, 24);
  for (int i = 1; i <= 4; ++i) {
    drag(i, -i);
    settle();
  }
  EXPECT_EQ(window->history().count(), 0);
  release(4, -4);
  settle();
  EXPECT_EQ(window->history().count(), 1);
  EXPECT_EQ(window->history().undoText().toStdString(), "move of a curve");
  window->history().undo();
  EXPECT_EQ(edits().size(), 0u);
  EXPECT_EQ(face().curves.points, before.curves.points);
}

TEST_F(CurveDrag, ThePointStaysUnderTheMouse) {
  grab(14, 24);
  drag(3, -2);
  release(3, -2);
  const QPointF off = handle->pixelOf(14, 24) - QPointF(start + QPoint(3, -2));
  EXPECT_LT(std::hypot(off.x(), off.y()), 1.0) << "half a pixel of the grip, and moves in hundredths of mm";
}

TEST_F(CurveDrag, EscapeCancels) {
  const mien::FaceCurves before = face();
  raise(0.5);
  const mien::FaceCurves raised = face();
  grab(14, 24);
  drag(2, -2);
  ASSERT_EQ(edits().size(), 2u);
  QTest::keyClick(view, Qt::Key_Escape);
  EXPECT_EQ(edits().size(), 1u);
  drag(4, -4);
  release(4, -4);
  EXPECT_EQ(face().curves.points, raised.curves.points);
  EXPECT_NE(face().curves.points, before.curves.points);
}

TEST_F(CurveDrag, ARefusedPlaceSnapsBackWithItsReason) {
  const mien::FaceCurves before = face();
  grab(14, 24);
  drag(0, -2);
  EXPECT_EQ(edits().size(), 1u);
  drag(0, -60);
  EXPECT_TRUE(edits().empty());
  EXPECT_TRUE(message().contains("C15")) << message().toStdString();
  EXPECT_EQ(face().curves.points, before.curves.points);
  drag(0, -2);
  EXPECT_EQ(edits().size(), 1u) << "back at a good place it goes on";
  EXPECT_EQ(message().toStdString(), "");
  drag(0, -60);
  release(0, -60);
  EXPECT_TRUE(edits().empty());
  EXPECT_TRUE(message().contains("C15"));
}

TEST_F(CurveDrag, PointsBehindTheFaceAndAClosedDockHaveNoHandles) {
  grab(14, 0);  // v = 0 is at the back of the head
  EXPECT_NE(handle->name(), QString("C15, v 0.0\u00b0"));
  QTest::keyClick(view, Qt::Key_Escape);
  find<QAction>("curvesDockAction")->trigger();
  EXPECT_FALSE(find<QToolButton>("curveDrag")->isChecked());
  grab(14, 24);
  EXPECT_FALSE(handle->isShown());
  release(0, 0);
  EXPECT_TRUE(edits().empty());
}

TEST_F(CurvePanel, SavedCurvesAreTheFaceOfTheMoves) {
  QTemporaryDir folder;
  raise(1.5);
  const mien::FaceCurves moved = face();
  auto* panel = find<mien::CurvePanel>("curvePanel");
  const QString name = folder.filePath("anna.vtp");
  EXPECT_TRUE(panel->save(name));
  click("curveClear");
  EXPECT_TRUE(edits().empty());
  window->model().change([&](mien::FaceState& state) { state.curvesFile = name.toStdString(); });
  EXPECT_TRUE(window->model().update());
  EXPECT_LT((face().curves.points - moved.curves.points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_FALSE(panel->save(folder.filePath("there_is_no_folder/anna.vtp")));
  EXPECT_TRUE(message().contains("there_is_no_folder")) << message().toStdString();
  EXPECT_FALSE(QFileInfo::exists(folder.filePath("anna.vtp.part")));
}

TEST_F(CurvePanel, EveryControlIsNamedExplainedAndReachedByKeyboard) {
  for (const char* name :
       {"curveCurve", "curvePoint", "curveWidth", "curveSpread", "curveMirror", "curveDx", "curveDy", "curveDz",
        "curveApply", "curveDrag", "curveEdits", "curveUndo", "curveRemove", "curveClear", "curveSave"}) {
    auto* control = find<QWidget>(name);
    EXPECT_FALSE(control->toolTip().isEmpty()) << name;
    EXPECT_TRUE(control->focusPolicy() & Qt::TabFocus) << name;
  }
}

}  // namespace
