#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <QDir>
#include <QFile>

#include "Comparison.h"
#include "FaceModel.h"
#include "SessionFixture.h"
#include "ViewArea.h"

namespace {

/// A session and the files that it names, which both may be somewhere else later.
class SessionFilesTest : public SessionFixture {
 protected:
  using Kind = mien::Comparison::Kind;

  /// An animation and a mesh in a folder, both open, and the session that names them, in another beside it.
  void saveAll() {
    QDir(folder.path()).mkpath("old/data");
    const QString motion = file("old/data/lids.fap"), mesh = file("old/data/face.vtp");
    ASSERT_TRUE(QFile::rename(writeLids(5, 25.0), motion));
    writeMesh(mesh);
    ASSERT_TRUE(window->openFile(motion));
    ASSERT_TRUE(comparison()->openMesh(mesh));
    settle();
    ASSERT_TRUE(window->document().save(session("old")));
  }
  void writeMesh(const QString& name) {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(name.toUtf8().constData());
    writer->SetInputData(surface());
    ASSERT_TRUE(writer->Write());
  }
  QString session(const char* in) const { return file(QString(in) + "/all" + mien::SessionFile::ending); }
  mien::Comparison* comparison() { return find<mien::ViewArea>("viewArea")->comparison(); }
  void openInANewWindow(const QString& name) {
    window = std::make_unique<mien::StudioWindow>();
    window->show();
    settle();
    ASSERT_TRUE(window->document().open(name)) << message().toStdString();
    settle();
  }
  QString motion() { return QString::fromStdString(window->model().state().fapFile); }
};

TEST_F(SessionFilesTest, ARelativeNameIsGoodFromEveryFolder) {
  saveAll();
  const QString before = QDir::currentPath();
  QDir::setCurrent(file("old"));
  EXPECT_TRUE(window->openFile("data/lids.fap"));
  QDir::setCurrent(before);
  EXPECT_TRUE(QFileInfo(motion()).isAbsolute()) << motion().toStdString();
  EXPECT_EQ(QFileInfo(motion()).canonicalFilePath(), QFileInfo(file("old/data/lids.fap")).canonicalFilePath());
}

TEST_F(SessionFilesTest, ASessionThatMovesWithItsFilesFindsThem) {
  saveAll();
  ASSERT_TRUE(QDir(folder.path()).rename("old", "new"));
  openInANewWindow(session("new"));
  EXPECT_EQ(motion(), file("new/data/lids.fap"));
  EXPECT_EQ(comparison()->kind(), Kind::Mesh);
  EXPECT_FALSE(message().contains("Left out")) << message().toStdString();
}

/// As where a disk is not mounted: one sentence names all, and saving keeps the names until the files are back.
TEST_F(SessionFilesTest, WhatIsGoneForATimeStaysInTheSession) {
  saveAll();
  ASSERT_TRUE(QDir(folder.path()).rename("old/data", "away"));
  openInANewWindow(session("old"));
  EXPECT_EQ(motion(), "");
  EXPECT_EQ(comparison()->kind(), Kind::None);
  EXPECT_TRUE(message().contains("lids.fap") && message().contains("face.vtp")) << message().toStdString();
  window->model().change([](mien::FaceState& state) { state.expressions["joy"] = 1.0; });
  settle();
  ASSERT_TRUE(window->document().save());
  ASSERT_TRUE(QDir(folder.path()).rename("away", "old/data"));
  openInANewWindow(session("old"));
  EXPECT_EQ(motion(), file("old/data/lids.fap"));
  EXPECT_EQ(comparison()->kind(), Kind::Mesh);
  EXPECT_EQ(window->model().state().expressions.count("joy"), 1u);
}

/// A hand can write anything anywhere.
TEST_F(SessionFilesTest, NamesInOddPlacesHarmNothing) {
  saveAll();
  nlohmann::json kept;
  ASSERT_EQ(mien::SessionFile::read(session("old"), kept), QString());
  for (const char* place : {"/window/geometry/file", "/window/splitters/viewSplitter/scan", "/file", "/folder/file",
                            "/docks/file", "/docks/window/file", "/docks/window/faceMesh/file", "/docks/odd/0/1/file",
                            "/docks/curvesDock/scanPanel/scan/file"}) {
    nlohmann::json odd = kept.flatten();
    const std::string above = std::string(place).substr(0, std::string(place).rfind('/'));
    odd.erase(above);
    odd[place] = "/gone.ply";
    ASSERT_EQ(mien::SessionFile::write(odd.unflatten(), session("old")), QString()) << place;
    window->document().open(session("old"));
    settle();
    EXPECT_TRUE(window->document().save(file("again.json"))) << place;
  }
}

/// What the user chose instead is what the session holds.
TEST_F(SessionFilesTest, WhatTakesThePlaceOfALostFileIsKept) {
  saveAll();
  ASSERT_TRUE(QDir(folder.path()).rename("old/data", "away"));
  openInANewWindow(session("old"));
  const QString other = writeLids(3, 25.0);
  ASSERT_TRUE(window->openFile(other));
  comparison()->compareScheme("four-curve");
  settle();
  ASSERT_TRUE(window->document().save());
  ASSERT_TRUE(QDir(folder.path()).rename("away", "old/data"));
  openInANewWindow(session("old"));
  EXPECT_EQ(motion(), other);
  EXPECT_EQ(comparison()->kind(), Kind::Scheme);
}

}  // namespace
