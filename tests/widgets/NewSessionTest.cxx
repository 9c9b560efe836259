#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <nlohmann/json.hpp>

#include "AnimationPlayer.h"
#include "Comparison.h"
#include "CurveFile.h"
#include "FaceModel.h"
#include "History.h"
#include "SessionDocument.h"
#include "StudioFixture.h"
#include "ViewArea.h"
#include "WidgetSettings.h"
#include "vtkBoundaryCurveReader.h"

namespace {

using json = nlohmann::json;
using mien::FaceState;

class NewSession : public StudioFixture {
 protected:
  json settingsNow() { return mien::WidgetSettings::read(*window, mien::WidgetSettings::Of::Session); }

  QTemporaryDir folder;
};

TEST_F(NewSession, IsAsAtTheStartWhereTheDocksAre) {
  const json start = settingsNow();
  find<QAction>("actionWorkspace2")->trigger();
  ASSERT_TRUE(window->openFile(writeLids(9, 25.0)));
  window->player().setRange(2, 5);
  window->model().change([](FaceState& state) {
    state.edits = {mien::CurveEdit::ofPoint(5, 20, 40)};
    state.edits[0].move = {0.1, 0.7, 0.3};
    state.surface.scheme = "tangent";
    state.rows = 83;
    state.fapValues = {{31, 100.5}};
    state.expressions = {{"joy", 0.3}};
    state.deformation = {"smile", 0.6, false};
  });
  ASSERT_TRUE(window->model().update()) << message().toStdString();
  find<QComboBox>("faceMesh")->setCurrentIndex(2);
  find<QToolButton>("curveLink")->setChecked(false);
  find<mien::FaceView>("faceView")->placeCamera({1, 2, 3}, {0.6, 0.0, 0.8}, 321.0);
  find<mien::ViewArea>("viewArea")->comparison()->pin();
  ASSERT_TRUE(window->document().save(folder.filePath("a.mien-session.json")));
  settle();
  find<QAction>("actionNewSession")->trigger();
  settle();
  EXPECT_EQ(window->model().state(), FaceState());
  EXPECT_EQ(window->windowTitle().toStdString(), "New session[*]");
  EXPECT_FALSE(window->document().isModified());
  EXPECT_EQ(window->history().undoText(), "");
  EXPECT_EQ(find<QTabBar>("workspaces")->currentIndex(), 1);
  EXPECT_TRUE(find<QDockWidget>("spectrumDock")->isVisible());
  json now = settingsNow();
  EXPECT_EQ(now["window"]["workspaceKeeper"], "Surface");
  for (const auto& dock : start.items())
    for (const auto& setting : dock.value().items())
      if (setting.key() != "workspaceKeeper") {
        EXPECT_EQ(now[dock.key()][setting.key()], setting.value()) << dock.key() << " " << setting.key();
      }
}

TEST_F(NewSession, AsksWhereChangesWouldBeLost) {
  auto answer = mien::SessionDocument::Answer::Cancel;
  int asked = 0;
  window->document().setQuestion([&] { return ++asked, answer; });
  QTest::keyClick(find<QComboBox>("faceMesh"), Qt::Key_Down);
  settle();
  find<QAction>("actionNewSession")->trigger();
  EXPECT_EQ(find<QComboBox>("faceMesh")->currentIndex(), 1);
  answer = mien::SessionDocument::Answer::Discard;
  find<QAction>("actionNewSession")->trigger();
  EXPECT_EQ(find<QComboBox>("faceMesh")->currentIndex(), 0);
  EXPECT_EQ(asked, 2);
}

TEST_F(NewSession, TheGenericFaceComesBackFromTheMenu) {
  auto* back = find<QAction>("actionGenericFace");
  EXPECT_FALSE(back->isEnabled());
  const QString curves = folder.filePath("curves.vtp");
  ASSERT_EQ(mien::writeCurveFile(window->model().pipeline().neutralCurves()->GetOutput(), curves.toStdString()), "");
  ASSERT_TRUE(window->openFile(curves));
  ASSERT_TRUE(back->isEnabled());
  back->trigger();
  settle();
  EXPECT_EQ(window->model().state(), FaceState());
  EXPECT_FALSE(back->isEnabled());
}

}  // namespace
