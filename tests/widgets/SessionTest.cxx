#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QSplitter>
#include <QTabBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <functional>
#include <nlohmann/json.hpp>

#include "AnimationPlayer.h"
#include "Comparison.h"
#include "CurveFile.h"
#include "FaceModel.h"
#include "FaceStateText.h"
#include "History.h"
#include "MessageBar.h"
#include "SessionDocument.h"
#include "SessionFile.h"
#include "SessionFixture.h"
#include "ViewArea.h"
#include "WidgetSettings.h"
#include "vtkBoundaryCurveReader.h"

namespace {

using json = nlohmann::json;
using mien::FaceState;
using mien::WidgetSettings;

class Session : public SessionFixture {
 protected:
  QString write(const QString& name, const QByteArray& text) {
    QFile out(file(name));
    out.open(QIODevice::WriteOnly);
    out.write(text);
    return out.fileName();
  }

  std::string state() { return mien::writeFaceState(window->model().state()); }

  /// A state in which nothing is as at the start.
  FaceState everyProperty() {
    const QString curves = file("curves.vtp"), table = file("table.json");
    EXPECT_EQ(mien::writeCurveFile(window->model().pipeline().neutralCurves()->GetOutput(), curves.toStdString()), "");
    QFile::copy(QString(MIEN_TEST_DIR) + "/../data/animation/animation_table.json", table);
    FaceState state;
    state.curvesFile = curves.toStdString();
    state.edits = {mien::CurveEdit::ofPoint(5, 20, 40)};
    state.edits[0].move = {0.1, 0.7, 1.0 / 3.0};
    state.surface.scheme = "tangent";
    state.surface.smoothing = {0.1, 0.2, 0.3, 1.0 / 3.0, 1, 2, 3, 4, 5};
    state.surface.modes = 7;
    state.surface.remainder = false;
    state.surface.derivativeStrength = 0.75;
    state.rows = 83;
    state.columns = 44;
    state.uniformRows = true;
    state.doublePrecision = true;
    state.fapFile = writeLids(9, 25.0).toStdString();
    state.frameChoice = FaceState::FrameChoice::Time;
    state.frame = 0.1;
    state.interpolateFrames = true;
    state.animationTable = table.toStdString();
    state.fapValues = {{31, 100.5}, {53, -20.0}};
    state.expressions = {{"joy", 0.3}};
    state.visemes = {{"U", 0.4}};
    state.deformation = {"smile", 0.6, false};
    state.texture = QString(MIEN_TEST_DIR "/../data/textures/painted.png").toStdString();
    state.textureMesh = QString(MIEN_TEST_DIR "/../data/textures/painted_7x7.csv").toStdString();
    return state;
  }
};

/// A property that is added must be added here too: this does not compile without it.
int propertiesThatDiffer(const FaceState& a, const FaceState& b) {
  const auto& [a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18] = a;
  const auto& [b1, b2, b3, b4, b5, b6, b7, b8, b9, b10, b11, b12, b13, b14, b15, b16, b17, b18] = b;
  return (a1 != b1) + (a2 != b2) + !(a3 == b3) + (a4 != b4) + (a5 != b5) + (a6 != b6) + (a7 != b7) + (a8 != b8) +
         (a9 != b9) + (a10 != b10) + (a11 != b11) + (a12 != b12) + (a13 != b13) + (a14 != b14) + (a15 != b15) +
         !(a16 == b16) + (a17 != b17) + (a18 != b18);
}

TEST_F(Session, KeepsEveryPropertyOfTheFace) {
  const FaceState all = everyProperty();
  ASSERT_EQ(propertiesThatDiffer(all, FaceState()), 18);
  window->model().change([&](FaceState& state) { state = all; });
  ASSERT_TRUE(window->model().update()) << message().toStdString();
  settle();
  const std::string before = state();
  reopen();
  EXPECT_EQ(state(), before);
  EXPECT_EQ(propertiesThatDiffer(window->model().state(), all), 0);
  EXPECT_FALSE(window->document().isModified());
}

/// Another value than the present one, of the same widget.
bool changeWidget(QObject* object) {
  if (auto* list = qobject_cast<QComboBox*>(object)) {
    if (list->count() < 2) return false;
    list->setCurrentIndex((list->currentIndex() + 1) % list->count());
  } else if (auto* whole = qobject_cast<QSpinBox*>(object)) {
    whole->setValue(whole->value() < whole->maximum() ? whole->value() + 1 : whole->value() - 1);
  } else if (auto* number = qobject_cast<QDoubleSpinBox*>(object)) {
    number->setValue(number->value() + (number->value() + 0.5 < number->maximum() ? 0.5 : -0.5));
  } else if (auto* button = qobject_cast<QAbstractButton*>(object)) {
    button->setChecked(!button->isChecked());
  } else if (auto* tabs = qobject_cast<QTabBar*>(object)) {
    tabs->setCurrentIndex(tabs->count() - 1);
  } else {
    return false;
  }
  return true;
}

TEST_F(Session, KeepsTheInputWidgetsOfEveryDock) {
  const json start = settings();
  std::map<std::string, int> changed;
  for (const auto& dock : start.items())
    for (const auto& setting : dock.value().items())
      if (auto* widget = const_cast<QObject*>(WidgetSettings::find(*window, dock.key(), setting.key())))
        changed[dock.key()] += changeWidget(widget);
  settle();
  for (const auto* dock : window->findChildren<QDockWidget*>())
    EXPECT_GT(changed[dock->objectName().toStdString()] + (dock->objectName() == "plotDock"), 0)
        << dock->objectName().toStdString() << " has nothing that a session keeps";
  const json before = settings();
  const std::string face = state();
  reopen();
  EXPECT_EQ(state(), face);
  EXPECT_EQ(json::diff(before, settings()).dump(1), "[]");
}

TEST_F(Session, KeepsPinsRangeRegionPlotCameraAndLayout) {
  ASSERT_TRUE(window->openFile(writeLids(20, 25.0)));
  window->player().setRange(3, 11);
  window->model().showFrame(5);
  window->model().change([](FaceState& state) { state.expressions["joy"] = 0.5; });
  settle();
  find<QToolButton>("vectorsPin")->click();
  find<QToolButton>("deformationPin")->click();
  find<QAction>("plotDockAction")->trigger();
  settle();
  find<QListWidget>("plotFAPs")->item(0)->setSelected(false);
  find<mien::FaceView>("faceView")->placeCamera({1, 2, 3}, {0.6, 0.0, 0.8}, 321.0);
  settle();
  const json before = settings();
  EXPECT_EQ(before["window"]["animationPlayer"], json({{"begin", 3}, {"end", 11}}));
  EXPECT_EQ(before["vectorsDock"]["vectorsPins"].size(), 1u);
  EXPECT_TRUE(before["deformationDock"]["deformationPinned"].contains("face"));
  EXPECT_EQ(before["plotDock"]["fapPlotPanel"]["faps"], json::array());
  EXPECT_TRUE(before["window"]["faceView"].contains("position"));
  reopen();
  EXPECT_EQ(json::diff(before, settings()).dump(1), "[]");
  EXPECT_TRUE(find<QDockWidget>("plotDock")->isVisible());
  EXPECT_TRUE(find<QToolButton>("deformationPin")->isChecked());
}

TEST_F(Session, KeepsEveryKindOfComparisonAndHowItIsShown) {
  const QString mesh = file("face.vtp");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(mesh.toUtf8().constData());
  writer->SetInputData(surface());
  ASSERT_TRUE(writer->Write());
  const auto comparison = [this] { return find<mien::ViewArea>("viewArea")->comparison(); };
  const std::function<void()> kinds[] = {[&] { comparison()->pin(); },
                                         [&] { comparison()->compareScheme("four-curve"); },
                                         [&] { EXPECT_TRUE(comparison()->openMesh(mesh)); }};
  window->model().change([](FaceState& state) { state.expressions["joy"] = 0.5; });
  for (const auto& compare : kinds) {
    compare();
    find<QWidget>("otherFaceView")->setUpdatesEnabled(false);
    settle();
    find<QComboBox>("compareArrows")->setCurrentIndex(2);
    find<QToolButton>("compareLink")->setChecked(false);
    find<QToolButton>("colorAutomatic")->setChecked(false);
    find<QDoubleSpinBox>("colorEnd")->setValue(3.25);
    settle();
    const json before = settings();
    ASSERT_NE(before["window"]["comparison"]["kind"], "none");
    reopen();
    EXPECT_EQ(json::diff(before, settings()).dump(1), "[]");
    EXPECT_EQ(find<QDoubleSpinBox>("colorEnd")->value(), 3.25);
  }
}

TEST_F(Session, KeepsTheWindowAndThePlacesOfItsDocks) {
  const auto dock = [this](const char* name) { return find<QDockWidget>(name); };
  window->resize(1500, 900);
  find<QAction>("spectrumDockAction")->trigger();
  find<QAction>("vectorsDockAction")->trigger();
  window->addDockWidget(Qt::RightDockWidgetArea, dock("surfaceDock"));
  window->tabifyDockWidget(dock("surfaceDock"), dock("vectorsDock"));
  dock("spectrumDock")->setFloating(true);
  dock("expressionDock")->hide();
  find<QSplitter>("viewSplitter")->setSizes({700, 200});
  settle();
  const QSize size = window->size();  // docks may need more
  const QList<int> sizes = find<QSplitter>("viewSplitter")->sizes();
  reopen();
  EXPECT_EQ(window->size(), size);
  EXPECT_EQ(window->dockWidgetArea(dock("surfaceDock")), Qt::RightDockWidgetArea);
  EXPECT_EQ(window->tabifiedDockWidgets(dock("surfaceDock")), QList<QDockWidget*>{dock("vectorsDock")});
  EXPECT_TRUE(dock("spectrumDock")->isFloating());
  EXPECT_TRUE(dock("spectrumDock")->isVisible());
  EXPECT_FALSE(dock("expressionDock")->isVisible());
  EXPECT_NEAR(find<QSplitter>("viewSplitter")->sizes()[0], sizes[0], 2);
}

TEST_F(Session, StartsWithFormatAndVersion) {
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  QFile saved(file("a.mien-session.json"));
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_TRUE(saved.readAll().startsWith("{\n \"format\": \"mien session\",\n \"version\": 1,\n"));
  EXPECT_EQ(window->windowTitle().toStdString(), "a.mien-session.json[*]");
}

TEST_F(Session, TheTitleNamesTheFileAndMarksWhatHasChanged) {
  EXPECT_EQ(window->windowTitle().toStdString(), "New session[*]");
  EXPECT_FALSE(window->isWindowModified());
  QTest::keyClick(find<QComboBox>("faceMesh"), Qt::Key_Down);
  settle();
  EXPECT_TRUE(window->isWindowModified());
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  EXPECT_EQ(window->windowTitle().toStdString(), "a.mien-session.json[*]");
  EXPECT_FALSE(window->isWindowModified());
  QTest::keyClick(find<QComboBox>("faceMesh"), Qt::Key_Down);
  settle();
  EXPECT_TRUE(window->isWindowModified());
  window->history().undo();
  EXPECT_FALSE(window->isWindowModified()) << "as it was saved";
}

TEST_F(Session, KeepsOfATextThatIsRefusedTheOneBefore) {
  auto* range = find<QLineEdit>("smoothingRange");
  const auto type = [&](const QString& text) {
    range->setText(text);
    emit range->editingFinished();
    settle();
  };
  type("0.5:2:3");
  type("from here to there");
  EXPECT_FALSE(message().isEmpty());
  EXPECT_EQ(settings()["smoothingDock"]["smoothingRange"], "0.5:2:3");
  reopen();
  EXPECT_EQ(find<QLineEdit>("smoothingRange")->text(), "0.5:2:3");
  EXPECT_EQ(message(), "");
}

TEST_F(Session, OfAnEarlierVersionWithARefusedTextSaysSoOnce) {
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  json session;
  ASSERT_EQ(mien::SessionFile::read(file("a.mien-session.json"), session), QString());
  session["docks"]["smoothingDock"]["smoothingRange"] = "nonsense";
  ASSERT_EQ(mien::SessionFile::write(session, file("b.mien-session.json")), QString());
  const size_t said = find<mien::MessageBar>("messageBar")->log().size();
  EXPECT_TRUE(window->document().open(file("b.mien-session.json")));
  EXPECT_EQ(find<mien::MessageBar>("messageBar")->log().size(), said + 1);
}

/// Entries of lists that have another name today.
TEST_F(Session, OfAnEarlierVersionChoosesWhatHadAnotherName) {
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  json kept;
  ASSERT_EQ(mien::SessionFile::read(file("a.mien-session.json"), kept), QString());
  const struct {
    const char *dock, *list, *before, *now;
  } cases[] = {{"window", "colorBy", "Largest curvature \u03ba1 (1/mm)", "Curvature \u03ba1 (1/mm)"},
               {"window", "colorBy", "Smallest curvature \u03ba2 (1/mm)", "Curvature \u03ba2 (1/mm)"},
               {"window", "faceMesh", "Shaded with mesh", "Both"},
               {"continuityDock", "continuityMeasure", "C1 jump", "C1 jump (relative)"},
               {"continuityDock", "continuityMeasure", "C2 jump", "C2 jump (relative)"},
               {"continuityDock", "continuityPart", "front only", "Front only"},
               {"curvesDock", "scanUnit", "Unit found", "Unit: automatic"}};
  for (const auto& one : cases) {
    json session = kept;
    ASSERT_TRUE(session["docks"][one.dock].contains(one.list)) << one.list;
    session["docks"][one.dock][one.list] = one.before;
    ASSERT_EQ(mien::SessionFile::write(session, file("b.mien-session.json")), QString());
    ASSERT_TRUE(window->document().open(file("b.mien-session.json")));
    settle();
    EXPECT_EQ(find<QComboBox>(one.list)->currentText(), QString::fromUtf8(one.now));
  }
}

TEST_F(Session, OpensTheStateThatAFigureCarries) {
  FaceState joy;
  joy.expressions["joy"] = 1.0;
  const QString name = write("figure.json", QByteArray::fromStdString(mien::writeFaceState(joy)));
  ASSERT_TRUE(window->openFile(name));
  EXPECT_EQ(window->model().state(), joy);
}

TEST_F(Session, OfADamagedFileSaysWhatIsWrongAndKeepsTheWindow) {
  window->model().change([](FaceState& state) { state.fapValues[31] = 200.0; });
  settle();
  const std::string before = state();
  const json widgets = settings();
  const std::map<QString, const char*> said = {
      {"face_mesh_folded", "mesh:6: "},
      {"face_missing", "'face' is missing"},
      {"face_number", "face state"},
      {"face_unknown_member", "nose"},
      {"face_unknown_scheme", "cubist"},
      {"format_missing", "'format' is not"},
      {"line1_binary", "line 1 is damaged"},
      {"line1_empty", "ends at line 1 (cut off?)"},
      {"line1_never_closed", "ends at line 1 (cut off?)"},
      {"line3_cut_off", "ends at line 3 (cut off?); open an earlier copy; nothing was changed"},
      {"no_object", "its JSON is no object"},
      {"number_too_large", "a number that is too large"},
      {"version_0", "'version'"},
      {"version_9", "a later version"},
      {"version_missing", "'version'"}};
  const QFileInfoList files = QDir(MIEN_TEST_DIR "/data/malformed/session").entryInfoList({"*.json"}, QDir::Files);
  EXPECT_EQ(files.size(), static_cast<int>(said.size()));
  for (const QFileInfo& damaged : files) {
    EXPECT_FALSE(window->document().open(damaged.filePath()));
    settle();
    EXPECT_TRUE(message().startsWith(damaged.fileName())) << message().toStdString();
    EXPECT_TRUE(message().contains(said.at(damaged.completeBaseName()))) << message().toStdString();
    EXPECT_EQ(state(), before) << damaged.fileName().toStdString();
    EXPECT_EQ(settings(), widgets) << damaged.fileName().toStdString();
  }
}

TEST_F(Session, WithValuesOfAnotherTypeLeavesThoseWidgetsAlone) {
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  json session;
  ASSERT_EQ(mien::SessionFile::read(file("a.mien-session.json"), session).toStdString(), "");
  const json before = settings();
  for (const json& wrong : {json(3.5), json("x"), json(true), json::array({1}), json::object({{"a", 1}})}) {
    json changed = session;
    for (auto& dock : changed["docks"].items())
      for (auto& setting : dock.value().items())
        if (setting.value().type() != wrong.type() && !setting.value().is_structured()) setting.value() = wrong;
    ASSERT_EQ(mien::SessionFile::write(changed, file("b.mien-session.json")).toStdString(), "");
    ASSERT_TRUE(window->document().open(file("b.mien-session.json")));
    EXPECT_EQ(window->model().state(), FaceState());
  }
  EXPECT_EQ(before.size(), settings().size());
}

TEST_F(Session, LeavesOutAFileThatIsGone) {
  const QString lids = writeLids(5, 25.0);
  ASSERT_TRUE(window->openFile(lids));
  window->model().change([](FaceState& state) { state.expressions["fear"] = 0.5; });
  ASSERT_TRUE(window->document().save(file("a.mien-session.json")));
  QFile::remove(lids);
  ASSERT_TRUE(window->document().open(file("a.mien-session.json")));
  EXPECT_TRUE(message().contains(lids)) << message().toStdString();
  EXPECT_EQ(window->model().state().fapFile, "");
  EXPECT_EQ(window->model().state().expressions.at("fear"), 0.5);
}

TEST_F(Session, ThatCannotBeWrittenIsSaid) {
  EXPECT_FALSE(window->document().save(file("no/such/folder/a.mien-session.json")));
  EXPECT_TRUE(message().contains("cannot be written")) << message().toStdString();
  EXPECT_EQ(window->document().fileName().toStdString(), "");
}

TEST_F(Session, AsksOnceWhereChangesWouldBeLost) {
  using Answer = mien::SessionDocument::Answer;
  int asked = 0;
  Answer answer = Answer::Cancel;
  window->document().setQuestion([&] { return ++asked, answer; });
  EXPECT_TRUE(window->document().mayClose());
  EXPECT_EQ(asked, 0);
  QTest::mouseClick(find<QPushButton>("surfaceReset"), Qt::LeftButton);
  QTest::keyClick(find<QComboBox>("faceMesh"), Qt::Key_Down);
  settle();
  EXPECT_TRUE(window->isWindowModified());
  EXPECT_FALSE(window->close());
  EXPECT_TRUE(window->isVisible());
  answer = Answer::Discard;
  EXPECT_TRUE(window->close());
  EXPECT_EQ(asked, 2);
}

}  // namespace
