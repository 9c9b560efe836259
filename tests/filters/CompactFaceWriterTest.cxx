#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <filesystem>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "FaceFiles.h"
#include "ReferenceData.h"
#include "RefusedFace.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "WholeFile.h"
#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkCompactFaceWriter.h"
#include "vtkFieldData.h"
#include "vtkPDEFaceFilter.h"
#include "vtkScanReader.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"

namespace {

void writeCompact(vtkPolyData* data, const std::string& file, double tolerance = 0.1) {
  vtkNew<vtkCompactFaceWriter> writer;
  ErrorCounter errors(writer);
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  writer->SetTolerance(tolerance);
  writer->SetFaceName("Anna");
  writer->Write();
  EXPECT_EQ(errors.first(), "");
}

/// What the reader makes of a file, and that a face filter accepts it.
mien::FaceCurves readBack(const std::string& file) {
  vtkNew<vtkBoundaryCurveReader> reader;
  ErrorCounter errors(reader);
  reader->SetFileName(file.c_str());
  vtkNew<vtkPDEFaceFilter> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  surface->Update();
  EXPECT_EQ(errors.first(), "");
  EXPECT_GT(surface->GetOutput()->GetNumberOfPoints(), 0);
  mien::FaceCurves face;
  EXPECT_EQ(mien::readFaceCurves(reader->GetOutput(), face), "");
  return face;
}

double rmsBetween(const mien::FaceCurves& a, const mien::FaceCurves& b) {
  return std::sqrt((a.curves.points - b.curves.points).rowwise().squaredNorm().mean());
}

}  // namespace

TEST(CompactFaceWriter, TheGenericFaceTakesAtMost1300BytesAtATenthOfAMillimetre) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.mienz");
  vtkNew<vtkBoundaryCurveReader> generic;
  generic->Update();
  writeCompact(generic->GetOutput(), file);
  EXPECT_LE(std::filesystem::file_size(file), 1300u);
  EXPECT_LE(rmsBetween(readBack(file), genericFace()), 0.1);
  EXPECT_EQ(readBack(file).features.size(), genericFace().features.size());
}

TEST(CompactFaceWriter, EveryHeadTakesAtMost2500Bytes) {
  MIEN_REQUIRE_REFERENCE("heads");
  const TemporaryFolder folder;
  int heads = 0;
  for (const auto& entry : std::filesystem::directory_iterator(referencePath("heads"))) {
    if (entry.path().extension() != ".ply") continue;
    vtkNew<vtkScanReader> scan;
    scan->SetFileName(entry.path().c_str());
    vtkNew<vtkBoundaryCurveAcquisitionFilter> curves;
    curves->SetInputConnection(scan->GetOutputPort());
    curves->SetLandmarkFileName(referencePath("heads/landmarks68.csv").c_str());
    curves->Update();
    mien::FaceCurves face;
    ASSERT_EQ(mien::readFaceCurves(curves->GetOutput(), face), "");
    const std::string file = folder.file("head.mienz");
    writeCompact(curves->GetOutput(), file);
    EXPECT_LE(std::filesystem::file_size(file), 2500u) << entry.path();
    EXPECT_LE(rmsBetween(readBack(file), face), 0.1) << entry.path();
    ++heads;
  }
  EXPECT_GE(heads, 13);
}

TEST(CompactFaceReader, StatesNameAndError) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.mienz");
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  writeCompact(reader->GetOutput(), file, 0.5);
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkFieldData* fields = reader->GetOutput()->GetFieldData();
  auto* name = vtkStringArray::SafeDownCast(fields->GetAbstractArray("FaceName"));
  ASSERT_TRUE(name && fields->GetArray("StoredError"));
  EXPECT_EQ(name->GetValue(0), "Anna");
  EXPECT_NEAR(fields->GetArray("StoredError")->GetComponent(0, 0), 0.5, 0.02);
  EXPECT_GT(fields->GetArray("StoredError")->GetComponent(0, 1), 0.5);
}

TEST(CompactFaceReader, TheFirstBytesTellTheFormatWhateverTheEnding) {
  const TemporaryFolder folder;
  vtkNew<vtkBoundaryCurveReader> generic;
  generic->Update();
  writeCompact(generic->GetOutput(), folder.file("face.bin"));
  EXPECT_LE(rmsBetween(readBack(folder.file("face.bin")), genericFace()), 0.1);
}

TEST(CompactFaceReader, WrongFilesAreRefusedWithTheirName) {
  const TemporaryFolder folder;
  expectRefusedFace(folder.file("none.mienz"), "there is no such file");
  for (const std::string text : {"", "MIENZ", "<VTKFile type=\"PolyData\">"}) {
    writeTextFile(folder.file("a.mienz"), text);
    expectRefusedFace(folder.file("a.mienz"), "copy the file again");
  }
  writeTextFile(folder.file("large.mienz"), std::string(std::size_t(5) << 20, 'M'));
  expectRefusedFace(folder.file("large.mienz"), "larger than any compact face");
}

TEST(CompactFaceWriter, FaultsAreErrorsAndLeaveNoFile) {
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkBoundaryCurveReader> generic;
  generic->Update();
  const auto fault = [&](vtkPolyData* data, const std::string& file, double tolerance) {
    vtkNew<vtkCompactFaceWriter> writer;
    ErrorCounter errors(writer);
    writer->SetInputData(data);
    writer->SetFileName(file.c_str());
    writer->SetTolerance(tolerance);
    writer->Write();
    return errors.first();
  };
  EXPECT_NE(fault(empty, folder.file("a.mienz"), 0.1).find("no lines"), std::string::npos);
  EXPECT_NE(fault(generic->GetOutput(), folder.file("a.mienz"), 0.0).find("tolerance"), std::string::npos);
  EXPECT_NE(fault(generic->GetOutput(), folder.file("none/a.mienz"), 0.1).find("cannot be written"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.mienz")));
}

TEST(CompactFaceWriter, ATurnedHeadIsStoredInItsOwnFrame) {
  const TemporaryFolder folder;
  mien::FaceCurves face = genericFace();
  mien::HeadRotation turned;
  turned.rotation = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
  turned.centre = {0.0, -40.0, 10.0};
  turned.apply(face.curves.points);
  vtkNew<vtkPolyData> data;
  mien::writeFaceCurves(face, data);
  mien::writeHeadRotation(turned, data->GetFieldData());
  vtkNew<vtkCompactFaceWriter> writer;
  int warnings = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&warnings);
  count->SetCallback([](vtkObject*, unsigned long, void* n, void*) { ++*static_cast<int*>(n); });
  writer->AddObserver(vtkCommand::WarningEvent, count);
  writer->SetInputData(data);
  writer->SetFileName(folder.file("a.mienz").c_str());
  writer->Write();
  EXPECT_EQ(warnings, 1);
  EXPECT_LE(rmsBetween(readBack(folder.file("a.mienz")), genericFace()), 0.1);
}

TEST(CompactFaceWriter, AFileThatCannotGetItsNameLeavesNothingBehind) {
  const TemporaryFolder folder;
  const std::string name = folder.file("face.mienz");
  std::filesystem::create_directory(name);
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkCompactFaceWriter> writer;
  ErrorCounter errors(writer);
  writer->SetInputConnection(curves->GetOutputPort());
  writer->SetFileName(name.c_str());
  writer->Write();
  EXPECT_NE(errors.first().find(name + ": it cannot be written"), std::string::npos) << errors.first();
  EXPECT_FALSE(std::filesystem::exists(mien::WholeFile::temporaryNameOf(name)));
}
