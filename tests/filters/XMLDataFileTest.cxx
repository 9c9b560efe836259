#include <gtest/gtest.h>

#include <sstream>

#include "ErrorCounter.h"
#include "FaceFiles.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "XMLCounts.h"
#include "XMLDataFile.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"
#include "vtkXMLPolyDataReader.h"

namespace {

std::string countFault(const std::string& text, std::uintmax_t size = 1000) {
  std::istringstream file(text);
  return mien::describeCountFault(file, size);
}

std::string readFault(const std::string& name, const std::string& text) {
  writeTextFile(name, text);
  vtkNew<vtkXMLPolyDataReader> reader;
  return mien::readXMLDataFile(name, reader);
}

}  // namespace

TEST(XMLDataFile, ReadsWhatVTKWritesInEveryMode) {
  const TemporaryFolder folder;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(sphere->GetOutputPort());
  writer->SetFileName(folder.file("a.vtp").c_str());
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    for (const int compressor : {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA}) {
      writer->SetDataMode(mode);
      writer->SetCompressorType(compressor);
      writer->Write();
      vtkNew<vtkXMLPolyDataReader> reader;
      EXPECT_EQ(mien::readXMLDataFile(folder.file("a.vtp"), reader), "") << mode << " " << compressor;
      EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 50);
    }
}

// VTK would ask for 10 terabytes and throw through Update().
TEST(XMLDataFile, CountsThatNoFileOfThisLengthHoldsAreRefused) {
  const TemporaryFolder folder;
  writeFaceFile(genericFace(), folder.file("face.vtp"));
  std::string text = readTextFile(folder.file("face.vtp"));
  const std::string honest = "NumberOfPoints=\"1160\"";
  ASSERT_NE(text.find(honest), std::string::npos);
  text.replace(text.find(honest), honest.size(), "NumberOfPoints=\"900000000000\"");
  const std::string fault = readFault(folder.file("damaged.vtp"), text);
  EXPECT_EQ(fault.rfind(folder.file("damaged.vtp") + ": NumberOfPoints", 0), 0u) << fault;
  vtkNew<vtkBoundaryCurveReader> reader;
  ErrorCounter errors(reader);
  reader->SetFileName(folder.file("damaged.vtp").c_str());
  reader->Update();
  EXPECT_NE(errors.first().find("NumberOfPoints"), std::string::npos) << errors.first();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(XMLDataFile, WhatIsNoXMLIsRefusedInOneSentenceAndInSilence) {
  const TemporaryFolder folder;
  for (const char* text :
       {"", "ply\n", "<VTKFile", "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"3\"><Points>"}) {
    testing::internal::CaptureStderr();
    const std::string fault = readFault(folder.file("x.vtp"), text);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << text;
    EXPECT_EQ(fault.rfind(folder.file("x.vtp") + ": ", 0), 0u) << text;
  }
}

TEST(XMLCounts, TakesTheLimitFromTheFilesLength) {
  EXPECT_EQ(countFault("<Piece NumberOfPoints=\"1000\">"), "");
  EXPECT_NE(countFault("<Piece NumberOfPoints=\"1001\">").find("NumberOfPoints=\"1001\""), std::string::npos);
  EXPECT_NE(countFault("<Piece  NumberOfPolys = '-1'>").find("NumberOfPolys"), std::string::npos);
  EXPECT_NE(countFault("<Piece NumberOfStrips=\"many\">"), "");
  EXPECT_EQ(countFault("<VTKFile compressor=\"vtkZLibDataCompressor\"><Piece NumberOfPoints=\"1000000\">"), "");
  EXPECT_NE(countFault("<VTKFile compressor=\"vtkZLibDataCompressor\"><Piece NumberOfPoints=\"2000000\">"), "");
}

TEST(XMLCounts, MultipliesExtentsAndComponents) {
  EXPECT_EQ(countFault("<StructuredGrid WholeExtent=\"0 19 0 9 0 0\">"), "");
  EXPECT_EQ(countFault("<StructuredGrid WholeExtent=\"0 -1 0 -1 0 -1\">"), "");
  EXPECT_NE(countFault("<StructuredGrid WholeExtent=\"0 99 0 99 0 0\">").find("WholeExtent"), std::string::npos);
  EXPECT_NE(countFault("<Piece NumberOfPoints=\"300\"><DataArray NumberOfComponents=\"9\">").find("NumberOfComponents"),
            std::string::npos);
  EXPECT_NE(countFault("<DataArray NumberOfTuples=\"1e12\">"), "");
  EXPECT_EQ(countFault("<AppendedData>_<Piece NumberOfPoints=\"9999\">"), "");  // from here on bytes are data
}
