#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QTemporaryDir>

#include "CompactFace.h"
#include "Comparison.h"
#include "FaceModel.h"
#include "FileOpener.h"
#include "ReferenceData.h"
#include "ReferenceFace.h"
#include "ScanPanel.h"
#include "StudioFixture.h"
#include "TexturePanel.h"

namespace {

using mien::FileKind;

const QString data = QString(MIEN_TEST_DIR) + "/../data/", malformed = QString(MIEN_TEST_DIR) + "/data/malformed/";

class FileOpener : public StudioFixture {
 protected:
  QTemporaryDir folder;

  QString write(const QString& name, const QByteArray& bytes) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    return file.fileName();
  }
  QString writeCompact() {
    std::string bytes;
    EXPECT_EQ(mien::encodeCompactFace(mien::referenceFace(), "Anna", 0.1, bytes), "");
    return write("anna.mienz", QByteArray::fromStdString(bytes));
  }
  bool isShown(const char* dock) { return !find<QDockWidget>(dock)->isHidden(); }
  const mien::FaceState& state() { return window->model().state(); }
};

TEST_F(FileOpener, KindsAreToldByContent) {
  EXPECT_EQ(mien::fileKind(data + "faces/generic.vtp"), FileKind::Curves);
  EXPECT_EQ(mien::fileKind(writeCompact()), FileKind::Curves);
  EXPECT_EQ(mien::fileKind(data + "textures/painted.png"), FileKind::Photograph);
  EXPECT_EQ(mien::fileKind(data + "textures/painted.csv"), FileKind::PhotographMesh);
  EXPECT_EQ(mien::fileKind(data + "faces/generic68.csv"), FileKind::Landmarks);
  EXPECT_EQ(mien::fileKind(write("p.csv", "landmark,x,y\n0,1,2\n")), FileKind::PhotographMesh);
  EXPECT_EQ(mien::fileKind(write("a.txt", "ply\nformat ascii 1.0\n")), FileKind::Scan);
  EXPECT_EQ(mien::fileKind(write("a.obj", "# made by hand\nv 0 0 0\n")), FileKind::Scan);
  EXPECT_EQ(mien::fileKind(write("a.stl", QByteArray(84, '\0'))), FileKind::Scan);
  EXPECT_EQ(mien::fileKind(write("a.off", "OFF\n3 1 0\n")), FileKind::Scan);
  EXPECT_EQ(mien::fileKind(write("a.vts", "<?xml version=\"1.0\"?>\n<VTKFile type=\"StructuredGrid\"")),
            FileKind::Mesh);
  EXPECT_EQ(mien::fileKind(write("a.vtp", "<VTKFile type=\"PolyData\"><Piece NumberOfPolys=\"9\"")), FileKind::Mesh);
  EXPECT_EQ(mien::fileKind(write("a.jpg", "\xFF\xD8\xFF\xE0")), FileKind::Photograph);
  EXPECT_EQ(mien::fileKind(write("a.tif", QByteArray("II*\0", 4))), FileKind::Photograph);
  EXPECT_EQ(mien::fileKind(write("a.bin", QByteArray(9, '\0'))), FileKind::Other);
  EXPECT_EQ(mien::fileKind(data + "animation/animation_table.json"), FileKind::AnimationTable);
  EXPECT_EQ(mien::fileKind(write("a.json", "{\"type\": \"FeatureCollection\"}")), FileKind::Json);
  EXPECT_EQ(mien::fileKind(write("b.json", "[1, 2]")), FileKind::Json);
  EXPECT_EQ(mien::fileKind(data + "animation/demo.fap"), FileKind::Animation);
}

TEST_F(FileOpener, CurvesBecomeTheFaceAndEditsEnd) {
  window->model().change([](mien::FaceState& changed) { changed.edits.emplace_back(); });
  const QString compact = writeCompact();
  ASSERT_TRUE(window->openFile(compact)) << message().toStdString();
  EXPECT_EQ(state().curvesFile, compact.toStdString());
  EXPECT_TRUE(state().edits.empty());
  EXPECT_TRUE(message().startsWith("anna.mienz is the face now")) << message().toStdString();
  EXPECT_FALSE(window->openFile(malformed + "mienz/one_bit_changed.mienz"));
  EXPECT_TRUE(message().contains("one_bit_changed.mienz")) << message().toStdString();
  EXPECT_EQ(state().curvesFile, compact.toStdString()) << "a refused file leaves the face alone";
  EXPECT_TRUE(window->openFile(data + "faces/generic.vtp"));
}

TEST_F(FileOpener, ScansGoToTheCurvesDock) {
  auto* panel = find<mien::ScanPanel>("scanPanel");
  EXPECT_FALSE(isShown("curvesDock"));
  EXPECT_TRUE(window->openFile(malformed + "scans/cut_off_in_faces.ply"));
  ASSERT_TRUE(waitUntil([&] { return !panel->isMeasuring(); }, 60000));
  EXPECT_TRUE(message().contains("cut_off_in_faces.ply")) << message().toStdString();
  EXPECT_FALSE(panel->hasScan());
  EXPECT_FALSE(isShown("curvesDock")) << "it would be empty";
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  EXPECT_TRUE(window->openFile(QString::fromStdString(referencePath("heads/subject01_neutral.ply"))));
  ASSERT_TRUE(waitUntil([&] { return panel->hasScan(); }, 120000));
  EXPECT_TRUE(isShown("curvesDock"));
}

TEST_F(FileOpener, APhotographThatIsRefusedOpensNoDock) {
  EXPECT_TRUE(window->openFile(write("cut.png", QByteArray("\x89PNG\r\n\x1a\n", 8))));
  ASSERT_TRUE(waitUntil([&] { return message().contains("cut.png"); }, 60000));
  settle();
  EXPECT_FALSE(isShown("textureDock"));
  EXPECT_TRUE(state().texture.empty());
}

TEST_F(FileOpener, PhotographsAndTheirMeshesGoToTheTextureDock) {
  EXPECT_FALSE(window->openFile(data + "textures/painted_7x7.csv"));
  EXPECT_TRUE(message().contains("open the photograph first")) << message().toStdString();
  EXPECT_TRUE(window->openFile(data + "textures/painted.png"));
  ASSERT_TRUE(waitUntil([&] { return isShown("textureDock"); }, 60000));
  EXPECT_TRUE(QString::fromStdString(state().texture).endsWith("painted.png"));
  EXPECT_TRUE(window->openFile(data + "textures/painted_7x7.csv"));
  EXPECT_TRUE(waitUntil([&] { return QString::fromStdString(state().textureMesh).endsWith("painted_7x7.csv"); }, 60000))
      << state().textureMesh;
}

TEST_F(FileOpener, SurfacesAreComparedWithTheFace) {
  const QString missing =
      write("cut.vts", "<?xml version=\"1.0\"?>\n<VTKFile type=\"StructuredGrid\" version=\"0.1\">");
  EXPECT_FALSE(window->openFile(missing));
  EXPECT_TRUE(message().contains("cut.vts")) << message().toStdString();
}

TEST_F(FileOpener, TheDialogueOffersAllEndings) {
  for (const char* ending : {"*.vtp", "*.mienz", "*.ply", "*.OBJ", "*.stl", "*.off", "*.jpg", "*.csv"})
    EXPECT_TRUE(mien::FileOpener::endings().split(' ').contains(ending)) << ending;
}

}  // namespace
