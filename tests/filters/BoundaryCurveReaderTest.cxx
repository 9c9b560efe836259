#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "FaceFiles.h"
#include "FaceLayout.h"
#include "RefusedFace.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace {

using Change = std::function<void(mien::FaceCurves&)>;

/// Reads a file that must be refused with a sentence that names the file and says `word`.

void expectFaceRefused(const Change& change, const std::string& word) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.vtp");
  writeChangedFace(change, file);
  expectRefusedFace(file, word);
}

/// The generic face as data, changed and written.
void expectDataRefused(const std::function<void(vtkPolyData*)>& change, const std::string& word) {
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> data;
  mien::writeFaceCurves(genericFace(), data);
  change(data);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(folder.file("face.vtp").c_str());
  writer->SetInputData(data);
  writer->Write();
  expectRefusedFace(folder.file("face.vtp"), word);
}

/// Every so many-th point of each curve.
mien::ClosedCurves thinned(const mien::ClosedCurves& curves, int step) {
  mien::ClosedCurves result(curves.count, curves.pointsPerCurve / step);
  for (int c = 0; c < result.count; ++c)
    for (int j = 0; j < result.pointsPerCurve; ++j) result.curve(c).row(j) = curves.curve(c).row(j * step);
  return result;
}

}  // namespace

TEST(BoundaryCurveReader, GivesTheGenericFaceWithoutAFile) {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  mien::FaceCurves face;
  EXPECT_EQ(mien::readFaceCurves(reader->GetOutput(), face), "");
  EXPECT_EQ(face.curves.count, mien::FaceLayout::curveCount);
  EXPECT_EQ(face.curves.pointsPerCurve, 40);
}

TEST(BoundaryCurveReader, CurvesOfTooFewOrOddPointsAreRefused) {
  expectFaceRefused([](mien::FaceCurves& face) { face.curves = thinned(face.curves, 10); },
                    "curves have 4 points each");
  expectFaceRefused([](mien::FaceCurves& face) { face.curves = thinned(face.curves, 8); }, "curves have 5 points each");
}

TEST(BoundaryCurveReader, CoordinatesThatAreNoNumbersAreRefusedWithCurveAndPoint) {
  const double infinity = std::numeric_limits<double>::infinity(), nothing = std::nan("");
  for (const double value : {nothing, infinity, -infinity})
    for (const int point : {7, 39})
      expectFaceRefused([&](mien::FaceCurves& face) { face.curves.curve(5)(point, 1) = value; },
                        "curve C6, point " + std::to_string(point) + " (counted from 0) is not a finite number");
  expectFaceRefused([&](mien::FaceCurves& face) { face.curves.curve(mien::FaceLayout::lowerLip)(3, 0) = nothing; },
                    "curve C22', point 3 (counted from 0) is not a finite number");
  expectFaceRefused([&](mien::FaceCurves& face) { face.curves.curve(28)(3, 2) = nothing; },
                    "curve C28, point 3 (counted from 0) is not");
}

TEST(BoundaryCurveReader, CrossedCurvesAreRefusedWithBothNames) {
  expectFaceRefused([](mien::FaceCurves& face) { face.curves.curve(8).row(20).swap(face.curves.curve(9).row(20)); },
                    "curve C9 lies below C10 at point 20");
  expectFaceRefused([](mien::FaceCurves& face) { face.curves.curve(22).col(1).array() += 0.5; },
                    "curve C22 lies below C22'");
}

TEST(BoundaryCurveReader, MissingCurvesAreRefusedWithTheirName) {
  expectDataRefused([](vtkPolyData* data) { data->GetCellData()->GetArray("CurveId")->SetTuple1(10, 3); },
                    "curve C11 is missing");
  expectDataRefused(
      [](vtkPolyData* data) {
        mien::ClosedCurves first(27, 40);
        first.points = genericFace().curves.points.topRows(27 * 40);
        mien::writeClosedCurves(first, data);
      },
      "curve C27 is missing");
}

TEST(BoundaryCurveReader, OtherFilesAreRefused) {
  const TemporaryFolder folder;
  expectRefusedFace(folder.file("none.vtp"), "there is no such file");
  for (const std::string text :
       {"", "2.1 lids 25 1\n", "<VTKFile type=\"PolyData\"", "<?xml version=\"1.0\"?><face/>"}) {
    writeTextFile(folder.file("text.vtp"), text);
    expectRefusedFace(folder.file("text.vtp"), "VTK XML");
  }
  const auto pointsOnly = [](vtkPolyData* data) {
    data->SetLines(vtkNew<vtkCellArray>());
    data->GetCellData()->Initialize();
  };
  expectDataRefused(pointsOnly, "there are no lines");
}

TEST(BoundaryCurveReader, KnowsInSilenceWhatItCanRead) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("other.vtp"), "<VTKFile type=\"PolyData\"><PolyData/></VTKFile>");
  EXPECT_EQ(vtkBoundaryCurveReader::CanReadFile(MIEN_DATA_DIR "/faces/generic.vtp"), 1);
  EXPECT_EQ(vtkBoundaryCurveReader::CanReadFile(folder.file("other.vtp").c_str()), 0);
  EXPECT_EQ(vtkBoundaryCurveReader::CanReadFile(folder.file("missing.vtp").c_str()), 0);
  EXPECT_EQ(vtkBoundaryCurveReader::CanReadFile(MIEN_DATA_DIR "/animation/demo.fap"), 0);
  EXPECT_EQ(vtkBoundaryCurveReader::CanReadFile(""), 0);
  EXPECT_EQ(vtkBoundaryCurveReader::CanReadFile(nullptr), 0);
}
