#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QWheelEvent>

#include "FAPTable.h"
#include "FaceModel.h"
#include "StudioFixture.h"
#include "ValueSlider.h"

namespace {

using FAPPanel = StudioFixture;
using mien::ValueSlider;

TEST_F(FAPPanel, HasASliderForEachOfThe22) {
  const std::vector<int> faps = mien::paperSubset();
  ASSERT_EQ(faps.size(), 22u);
  for (int fap : faps) {
    EXPECT_FALSE(find<ValueSlider>(QString("fapSlider%1").arg(fap))->toolTip().isEmpty());
    EXPECT_TRUE(find<QDoubleSpinBox>(QString("fapValue%1").arg(fap))->suffix().size() > 1);
  }
  EXPECT_EQ(find<QTabBar>("fapTabs")->count(), 5);
}

TEST_F(FAPPanel, DraggingASliderWithTheMouseMovesTheCurves) {
  auto* slider = find<ValueSlider>("fapSlider31");
  ASSERT_TRUE(slider->isVisible());
  const QPoint middle = slider->rect().center();
  ASSERT_EQ(largestDisplacement(), 0.0);
  QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, middle);
  dragTo(slider, middle + QPoint(30, 0));
  const double near = largestDisplacement();
  dragTo(slider, middle + QPoint(60, 0));
  QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, middle + QPoint(60, 0));
  EXPECT_GT(near, 1.0);
  EXPECT_GT(largestDisplacement(), 1.5 * near);
  EXPECT_EQ(window->model().state().fapValues.at(31), slider->value());
}

TEST_F(FAPPanel, KeysMoveASliderAndTheCurves) {
  auto* slider = find<ValueSlider>("fapSlider33");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageUp);
  QTest::keyClick(slider, Qt::Key_Right);
  EXPECT_EQ(slider->value(), 68);
  EXPECT_GT(largestDisplacement(), 0.5);
}

TEST_F(FAPPanel, NumbersCanBeTypedBeyondTheSlider) {
  auto* number = find<QDoubleSpinBox>("fapValue31");
  number->selectAll();
  QTest::keyClicks(number, "600");
  QTest::keyClick(number, Qt::Key_Return);
  EXPECT_EQ(window->model().state().fapValues.at(31), 600.0);
  EXPECT_EQ(find<ValueSlider>("fapSlider31")->value(), find<ValueSlider>("fapSlider31")->maximum());
  EXPECT_EQ(number->value(), 600.0);
}

TEST_F(FAPPanel, ALengthIsShownInMillimetresOfThisFace) {
  find<QDoubleSpinBox>("fapValue31")->setValue(100.0);
  settle();
  const double expected = 100.0 * window->model().millimetresPerUnit(31);
  EXPECT_GT(expected, 1.0);
  EXPECT_EQ(find<QLabel>("fapLength31")->text(), QString("%1 mm").arg(expected, 0, 'f', 1));
}

/// As figures beside them do, in labels and in fields, which read both.
TEST_F(FAPPanel, NegativeNumbersHaveARealMinus) {
  auto* number = find<QDoubleSpinBox>("fapValue31");
  for (const QString& typed : {QString("-300"), QString(QChar(0x2212)) + "300"}) {
    number->selectAll();
    QTest::keyClicks(number, "0\r");
    number->selectAll();
    number->findChild<QLineEdit*>()->insert(typed);
    QTest::keyClick(number, Qt::Key_Return);
    settle();
    EXPECT_EQ(number->value(), -300.0);
    EXPECT_EQ(number->text(), QString(QChar(0x2212)) + "300 ENS");
    EXPECT_EQ(find<QLabel>("fapLength31")->text().at(0), QChar(0x2212));
    EXPECT_FALSE(find<QLabel>("fapLength31")->text().contains('-'));
  }
}

TEST_F(FAPPanel, WhatAnExpressionAddsIsExplained) {
  const auto tip = [this](const char* name) { return find<QWidget>(name)->toolTip(); };
  find<QDoubleSpinBox>("fapValue31")->setValue(100.0);
  settle();
  EXPECT_FALSE(tip("fapLength31").contains("in all"));
  window->model().change([](mien::FaceState& state) { state.expressions["fear"] = 1.0; });
  settle();
  const QString shown = find<QLabel>("fapLength31")->text();
  for (const char* name : {"fapLength31", "fapSlider31"})
    EXPECT_TRUE(tip(name).contains("<b>" + shown + "</b> in all")) << tip(name).toStdString();
  window->model().change([](mien::FaceState& state) { state.expressions.clear(); });
  settle();
  EXPECT_FALSE(tip("fapSlider31").contains("in all"));
  EXPECT_FALSE(tip("fapSlider31").isEmpty());
}

TEST_F(FAPPanel, MirrorMovesBothSidesAndNoneWithoutIt) {
  auto* left = find<QDoubleSpinBox>("fapValue31");
  auto* right = find<QDoubleSpinBox>("fapValue32");
  left->setValue(80.0);
  EXPECT_EQ(right->value(), 80.0);
  find<QCheckBox>("fapMirror")->setChecked(false);
  right->setValue(-40.0);
  EXPECT_EQ(left->value(), 80.0);
  EXPECT_EQ(window->model().state().fapValues.at(32), -40.0);
}

TEST_F(FAPPanel, TheLockTurnsSignsWhereTheMirroredMotionDoes) {
  find<QToolButton>("fapAll")->click();
  auto* mirror = find<QCheckBox>("fapMirror");
  ASSERT_TRUE(mirror->isChecked());
  for (const mien::FAPDefinition& fap : mien::fapTable) {
    if (fap.mirrorPartner == fap.number || !window->model().moves(fap.number)) continue;
    const double value = fap.bidirectional ? -30.0 : 30.0;
    find<QDoubleSpinBox>(QString("fapValue%1").arg(fap.number))->setValue(value);
    EXPECT_EQ(window->model().state().fapValues.at(fap.mirrorPartner), fap.mirrorSign * value) << fap.number;
    EXPECT_EQ(find<QDoubleSpinBox>(QString("fapValue%1").arg(fap.mirrorPartner))->value(), fap.mirrorSign * value);
  }
  find<QPushButton>("fapResetAll")->click();
  find<QDoubleSpinBox>("fapValue49")->setValue(900.0);
  EXPECT_EQ(window->model().state().fapValues.size(), 1u) << "a FAP of the midline has no partner";
}

TEST_F(FAPPanel, TheLockIsSeenAtEachFAPAndWorksFromTheKeyboard) {
  auto* name = find<QLabel>("fapName31");
  EXPECT_TRUE(name->text().endsWith(QChar(0x21c4)));
  QApplication::setActiveWindow(window.get());
  QTest::keyClick(window.get(), Qt::Key_M, Qt::AltModifier);
  EXPECT_TRUE(waitUntil([this] { return !find<QCheckBox>("fapMirror")->isChecked(); }))
      << "a shortcut shows the button pressed first";
  EXPECT_FALSE(name->text().endsWith(QChar(0x21c4)));
}

TEST_F(FAPPanel, AllFAPsAreOneClickAway) {
  auto* all = find<QToolButton>("fapAll");
  auto* jaw = find<QWidget>("fapSlider3");
  EXPECT_FALSE(jaw->isVisible());
  QTest::mouseClick(all, Qt::LeftButton);
  settle();
  int rows = 0;
  for (const mien::FAPDefinition& fap : mien::fapTable) {
    auto* slider = window->findChild<ValueSlider*>(QString("fapSlider%1").arg(fap.number));
    const bool expected = fap.number >= 3 && fap.hasSurface;
    EXPECT_EQ(slider != nullptr, expected) << fap.number;
    rows += slider && slider->isVisibleTo(window.get());
    if (slider) {
      EXPECT_EQ(slider->isEnabled(), window->model().moves(fap.number)) << fap.number;
    }
  }
  EXPECT_EQ(rows, 49);
  auto* eyes = find<QLabel>("fapWithoutSurface3");
  EXPECT_TRUE(eyes->isVisibleTo(window.get()));
  EXPECT_TRUE(eyes->text().endsWith("23, 24, 25, 26, 27, 28, 29, 30")) << eyes->text().toStdString();
  EXPECT_TRUE(eyes->toolTip().contains("eyeballs"));
  QTest::mouseClick(all, Qt::LeftButton);
  EXPECT_FALSE(jaw->isVisible());
  EXPECT_TRUE(find<ValueSlider>("fapSlider31")->isVisible());
}

TEST_F(FAPPanel, AFAPOfTheListMovesTheFace) {
  find<QToolButton>("fapAll")->click();
  find<QDoubleSpinBox>("fapValue3")->setValue(300.0);
  EXPECT_GT(largestDisplacement(), 3.0);
}

TEST_F(FAPPanel, TheSearchFindsByNameNumberAndFeaturePoint) {
  auto* search = find<QLineEdit>("fapSearch");
  const auto found = [this] {
    settle();
    std::vector<int> faps;
    for (int fap = 3; fap <= 68; ++fap) {
      auto* slider = window->findChild<ValueSlider*>(QString("fapSlider%1").arg(fap));
      if (slider && slider->isVisibleTo(window.get())) faps.push_back(fap);
    }
    return faps;
  };
  find<QToolButton>("fapAll")->click();
  EXPECT_TRUE(search->isVisible());
  QTest::keyClicks(search, "outer brow");
  EXPECT_EQ(found(), (std::vector<int>{35, 36}));
  search->setText("31");
  EXPECT_EQ(found(), (std::vector<int>{31}));
  search->setText("8.3");
  EXPECT_EQ(found(), (std::vector<int>{53, 59}));
  search->setText("elbow");
  EXPECT_TRUE(found().empty());
  EXPECT_TRUE(find<QLabel>("fapNothingFound")->isVisible());
  search->clear();
  EXPECT_EQ(found().size(), 49u);
}

TEST_F(FAPPanel, ScrollingTheListChangesNoNumber) {
  find<QToolButton>("fapAll")->click();
  auto* number = find<QDoubleSpinBox>("fapValue48");
  settle();
  QWheelEvent wheel(QPointF(5, 5), QPointF(number->mapToGlobal(QPoint(5, 5))), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(number, &wheel);
  EXPECT_EQ(number->value(), 0.0);
}

TEST(FAPPanelMemory, LockAndListAreAsTheyWereAtTheLastStart) {
  QTemporaryDir folder;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
  QCoreApplication::setOrganizationName("mien-test");
  {
    mien::StudioWindow first;
    first.findChild<QCheckBox*>("fapMirror")->setChecked(false);
    first.findChild<QToolButton*>("fapAll")->click();
  }
  mien::StudioWindow second;
  EXPECT_FALSE(second.findChild<QCheckBox*>("fapMirror")->isChecked());
  EXPECT_TRUE(second.findChild<QToolButton*>("fapAll")->isChecked());
  QCoreApplication::setOrganizationName(QString());
}

TEST_F(FAPPanel, ResetsOneOrAll) {
  find<QDoubleSpinBox>("fapValue31")->setValue(80.0);
  find<QDoubleSpinBox>("fapValue33")->setValue(50.0);
  QTest::mouseClick(find<QToolButton>("fapReset31"), Qt::LeftButton);
  EXPECT_EQ(window->model().state().fapValues.count(31), 0u);
  EXPECT_EQ(window->model().state().fapValues.count(33), 1u);
  EXPECT_GT(largestDisplacement(), 0.5);
  QTest::mouseClick(find<QPushButton>("fapResetAll"), Qt::LeftButton);
  EXPECT_TRUE(window->model().state().fapValues.empty());
  EXPECT_EQ(find<QDoubleSpinBox>("fapValue33")->value(), 0.0);
  EXPECT_EQ(largestDisplacement(), 0.0);
}

TEST_F(FAPPanel, ADoubleClickSetsASliderToZero) {
  find<QDoubleSpinBox>("fapValue31")->setValue(80.0);
  auto* slider = find<ValueSlider>("fapSlider31");
  QTest::mouseDClick(slider, Qt::LeftButton, Qt::NoModifier, QPoint(20, slider->height() / 2));
  EXPECT_EQ(slider->value(), 0);
}

TEST_F(FAPPanel, ThePipelineKeepsUpWithADraggedSlider) {
  auto* slider = find<ValueSlider>("fapSlider33");
  int updates = 0;
  QObject::connect(&window->model(), &mien::FaceModel::updated, [&updates] { ++updates; });
  for (int value = 1; value <= 50; ++value) slider->setValue(4 * value);
  settle();
  EXPECT_EQ(updates, 1) << "changes that come together are shown once";
  EXPECT_EQ(window->model().state().fapValues.at(33), 200.0);
}

}  // namespace
