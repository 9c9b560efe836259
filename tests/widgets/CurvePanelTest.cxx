#include <gtest/gtest.h>
#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QListWidget>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>

#include "BoundaryCurveData.h"
#include "CurvePanel.h"
#include "FaceModel.h"
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
        "curveApply", "curveEdits", "curveUndo", "curveRemove", "curveClear", "curveSave"}) {
    auto* control = find<QWidget>(name);
    EXPECT_FALSE(control->toolTip().isEmpty()) << name;
    EXPECT_TRUE(control->focusPolicy() & Qt::TabFocus) << name;
  }
}

}  // namespace
