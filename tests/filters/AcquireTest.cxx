#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>

#include "Acquire.h"
#include "BoundaryCurveData.h"
#include "LandmarkTable.h"
#include "SyntheticHead.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace {

std::string temporary(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.file(name);
}

std::string writeScan(const std::string& name, double width) {
  SyntheticHead head = ellipticHead();
  const auto radius = head.radius;
  head.radius = [radius, width](double azimuth, double y) { return width * radius(azimuth, y); };
  const mien::TriangleMesh mesh = head.mesh();
  std::ofstream file(temporary(name));
  file.precision(12);
  for (int i = 0; i < mesh.vertices.rows(); ++i) file << "v " << mesh.vertices.row(i) << "\n";
  for (int i = 0; i < mesh.triangles.rows(); ++i) file << "f " << mesh.triangles.row(i).array() + 1 << "\n";
  return temporary(name);
}

std::string writeLandmarks(const std::string& name, int dropped = -1) {
  const mien::FaceLandmarks landmarks = ellipticHead().landmarks();
  std::ofstream file(temporary(name));
  file.precision(12);
  file << "landmark,x,y,z\n";
  for (int i = 0; i < 68; ++i)
    if (i != dropped)
      file << i << "," << landmarks[i].x() << "," << landmarks[i].y() << "," << landmarks[i].z() << "\n";
  return temporary(name);
}

mien::FaceCurves readFace(const std::string& file) {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  mien::FaceCurves face;
  EXPECT_EQ(mien::readFaceCurves(reader->GetOutput(), face), "");
  return face;
}

}  // namespace

TEST(Acquire, WritesTheMeanOfSeveralScans) {
  mien::AcquireOptions options;
  options.scans = {writeScan("narrow.obj", 0.98), writeScan("wide.obj", 1.02)};
  options.landmarkFile = writeLandmarks("landmarks.csv");
  options.outputFile = temporary("mean.vtp");
  options.mean = true;
  options.scan.pointsPerCurve = 48;
  ASSERT_EQ(mien::acquire(options), "");
  const mien::FaceCurves face = readFace(options.outputFile);
  EXPECT_EQ(face.curves.pointsPerCurve, 48);
  EXPECT_TRUE(face.hasPupils);
  EXPECT_NE(face.feature("8.3"), nullptr);
  const Eigen::Vector3d forehead = face.curves.curve(2).row(24);
  EXPECT_NEAR(forehead.z() - 25.0, ellipticHead().radius(0.0, forehead.y()), 1.0);
  EXPECT_EQ(forehead.x(), 0.0);
}

TEST(Acquire, NamesTheFileAtFaultAndWritesNothing) {
  mien::AcquireOptions options;
  options.scans = {writeScan("head.obj", 1.0)};
  options.landmarkFile = writeLandmarks("short.csv", 30);
  options.outputFile = temporary("nothing.vtp");
  std::filesystem::remove(options.outputFile);
  EXPECT_EQ(mien::acquire(options), options.landmarkFile +
                                        ":68: landmark 30 (nose_tip) is missing; the twelve landmarks with names are "
                                        "needed, see mien acquire --help");
  options.landmarkFile = "/no/landmarks.csv";
  EXPECT_EQ(mien::acquire(options).rfind("/no/landmarks.csv: ", 0), 0u);
  options.landmarkFile = writeLandmarks("landmarks.csv");
  options.scan.pointsPerCurve = 41;
  EXPECT_NE(mien::acquire(options).find("even number"), std::string::npos);
  options.scan.pointsPerCurve = 40;
  options.scans = {temporary("not_there.ply")};
  EXPECT_EQ(mien::acquire(options).rfind(options.scans[0] + ": ", 0), 0u);
  options.scans = {temporary("head.obj"), temporary("head.obj")};
  EXPECT_NE(mien::acquire(options).find("mean"), std::string::npos);
  options.scans.clear();
  EXPECT_NE(mien::acquire(options), "");
  EXPECT_FALSE(std::filesystem::exists(options.outputFile));
}

TEST(Acquire, SaysWhenTheOutputCannotBeWritten) {
  mien::AcquireOptions options;
  options.scans = {writeScan("head.obj", 1.0)};
  options.landmarkFile = writeLandmarks("landmarks.csv");
  options.outputFile = "/no/such/folder/face.vtp";
  EXPECT_EQ(mien::acquire(options).rfind(options.outputFile + ": ", 0), 0u);
}

/// Landmarks of a scan in metres that was turned and shifted come back as they were given, so that they can be mended
/// and given again.
TEST(Acquire, LandmarksAreWrittenInTheFrameOfTheScan) {
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, 2, 3).normalized()));
  const mien::Similarity moved = {0.001, turn, {0.4, -0.2, 0.1}};
  const mien::TriangleMesh mesh = ellipticHead().mesh();
  const mien::FaceLandmarks landmarks = ellipticHead().landmarks();
  mien::AcquireOptions options;
  options.scans = {temporary("turned.obj")};
  options.landmarkFile = temporary("turned.csv");
  std::ofstream scan(options.scans[0]), table(options.landmarkFile);
  scan.precision(15);
  table.precision(15);
  for (int i = 0; i < mesh.vertices.rows(); ++i)
    scan << "v " << moved(mesh.vertices.row(i).transpose()).transpose() << "\n";
  for (int i = 0; i < mesh.triangles.rows(); ++i) scan << "f " << mesh.triangles.row(i).array() + 1 << "\n";
  table << "landmark,x,y,z\n";
  for (int i = 0; i < 68; ++i) {
    const Eigen::Vector3d place = moved(landmarks[i]);
    table << i << "," << place.x() << "," << place.y() << "," << place.z() << "\n";
  }
  scan.close();
  table.close();
  options.outputFile = temporary("turned.vtp");
  options.landmarkOutput = temporary("again.csv");
  ASSERT_EQ(mien::acquire(options), "");
  mien::LandmarkTable again;
  ASSERT_EQ(mien::parseLandmarks(readTextFile(options.landmarkOutput), again), "");
  for (int i = 0; i < 68; ++i) EXPECT_LT((again.positions[i] - moved(landmarks[i])).norm(), 1e-8) << i;
}

TEST(Acquire, WritesAllFilesOrNone) {
  const TemporaryFolder folder;
  mien::AcquireOptions options;
  options.scans = {writeScan("head.obj", 1.0)};
  options.landmarkFile = writeLandmarks("landmarks.csv");
  options.landmarkOutput = folder.file("landmarks.csv");
  options.outputFile = folder.file("none/face.vtp");
  EXPECT_NE(mien::acquire(options), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("")));
}
