#include <gtest/gtest.h>

#include <fstream>

#include "DefaultRegions.h"
#include "FDTData.h"
#include "NamedTables.h"
#include "PackedTable.h"
#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "WholeFile.h"
#include "vtkDoubleArray.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFDTReader.h"
#include "vtkFDTWriter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace {

const std::string smileFile = std::string(MIEN_DATA_DIR) + "/deformation/obaid2009_smile.csv";

/// The centres of the 16 regions on a face whose pupils are 60 mm apart.
vtkSmartPointer<vtkPolyData> centres() {
  vtkNew<vtkPoints> points;
  for (int region = 1; region <= 16; ++region) {
    const Eigen::Vector2d centre = mien::defaultRegions().centre(region);
    points->InsertNextPoint(30.0 * centre.x(), 30.0 * centre.y() + 10.0, 80.0);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

void setPupils(vtkFDTDeformationFilter* filter) {
  filter->SetLeftPupil(30.0, 10.0, 80.0);
  filter->SetRightPupil(-30.0, 10.0, 80.0);
}

std::vector<double> moves(vtkFDTDeformationFilter* filter) {
  filter->Update();
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray("Displacement");
  std::vector<double> result;
  for (vtkIdType i = 0; array && i < 3 * array->GetNumberOfTuples(); ++i)
    result.push_back(array->GetComponent(i / 3, i % 3));
  return result;
}

}  // namespace

TEST(FDTDeformationFilter, TheSmileOfThePaperSmiles) {
  vtkNew<vtkFDTReader> reader;
  reader->SetFileName(smileFile.c_str());
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputData(centres());
  filter->SetTableConnection(reader->GetOutputPort());
  setPupils(filter);
  const std::vector<double> full = moves(filter);
  ASSERT_EQ(full.size(), 48u);
  EXPECT_GT(full[3 * 9 + 1], 1.0) << "right cheek up";
  EXPECT_GT(full[3 * 10 + 1], 1.0) << "left cheek up";
  EXPECT_LT(full[3 * 15 + 1], -1.0) << "chin down";
  EXPECT_EQ(full[3 * 15 + 2], 0.0);
  filter->SetStrength(0.5);
  const std::vector<double> half = moves(filter);
  for (std::size_t i = 0; i < 48; ++i) EXPECT_NEAR(half[i], 0.5 * full[i], 1e-12);
}

TEST(FDTDeformationFilter, InterpolatesBetweenTables) {
  mien::DeformationTable up, left;
  for (int i = 0; i < 16; ++i) {
    up.maps[i].coefficients(1, 5) = 0.1;
    left.maps[i].coefficients(0, 5) = 0.2;
  }
  vtkNew<vtkTable> a, b;
  mien::writeFDT(up, a);
  mien::writeFDT(left, b);
  vtkNew<vtkFDTDeformationFilter> filter;
  filter->SetInputData(centres());
  filter->SetTableData(a);
  filter->SetOtherTableData(b);
  setPupils(filter);
  filter->SetInterpolation(0.25);
  const std::vector<double> result = moves(filter);
  ASSERT_EQ(result.size(), 48u);
  EXPECT_NEAR(result[0], 30.0 * 0.05, 1e-12);
  EXPECT_NEAR(result[1], 30.0 * 0.075, 1e-12);
}

TEST(FDTDeformationFilter, RefusesPupilsThatWereNotSet) {
  vtkNew<vtkTable> table;
  mien::writeFDT(mien::DeformationTable(), table);
  vtkNew<vtkFDTDeformationFilter> filter;
  mien::PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(centres());
  filter->SetTableData(table);
  EXPECT_TRUE(moves(filter).empty());
  EXPECT_NE(errors.first().find("there are no pupils"), std::string::npos);
}

TEST(FDTFiles, WhatIsWrittenIsReadBack) {
  const TemporaryFolder folder;
  const std::string file = folder.file("table.csv");
  mien::DeformationTable table;
  for (int i = 0; i < 16; ++i) table.maps[i].coefficients(0, 1) = 0.1 / (i + 1);
  vtkNew<vtkTable> data;
  mien::writeFDT(table, data);
  EXPECT_EQ(data->GetNumberOfRows(), 16);
  vtkNew<vtkFDTWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  writer->SetComment("a test");
  writer->Write();
  vtkNew<vtkFDTReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  mien::DeformationTable read;
  ASSERT_EQ(mien::readFDT(reader->GetOutput(), read), "");
  for (int i = 0; i < 16; ++i) EXPECT_EQ(read.maps[i].coefficients, table.maps[i].coefficients);
}

TEST(FDTFiles, PackedTablesAreReadBackWithinTheirError) {
  const TemporaryFolder folder;
  const std::string file = folder.file("joy.fdt");
  const mien::DeformationTable& joy = *mien::namedTable("joy");
  vtkNew<vtkTable> data;
  mien::writeFDT(joy, data);
  vtkNew<vtkFDTWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  writer->SetBits(16);
  writer->Write();
  EXPECT_EQ(readTextFile(file).size(), 412u);
  vtkNew<vtkFDTReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  mien::DeformationTable read;
  ASSERT_EQ(mien::readFDT(reader->GetOutput(), read), "");
  const Eigen::Vector2d chin(0.0, -3.4);
  EXPECT_LT((read.maps[15].apply(chin) - joy.maps[15].apply(chin)).norm(), mien::packingError(joy, 16, 0.8));
  writeTextFile(file, readTextFile(file).substr(0, 100));
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(errors.first().rfind(file + ": it has 100 bytes", 0), 0u) << errors.first();
}

TEST(FDTFiles, NothingHalfIsWritten) {
  const TemporaryFolder folder;
  mien::DeformationTable table = *mien::namedTable("joy");
  vtkNew<vtkTable> data;
  mien::writeFDT(table, data);
  vtkNew<vtkFDTWriter> writer;
  mien::PipelineErrors errors;
  errors.observe(writer);
  writer->SetInputData(data);
  writer->Write();
  EXPECT_NE(errors.first().find("there is no file name"), std::string::npos) << errors.first();
  errors.clear();
  const std::string file = folder.file("joy.fdt");
  writeTextFile(file, "precious");
  table.maps[0].coefficients(0, 0) = 1e12;
  mien::writeFDT(table, data);
  writer->SetInputData(data);
  writer->SetFileName(file.c_str());
  writer->SetBits(8);
  writer->Write();
  EXPECT_NE(errors.first().find("beyond -100 .. 100"), std::string::npos) << errors.first();
  EXPECT_EQ(readTextFile(file), "precious");
  errors.clear();
  mien::writeFDT(*mien::namedTable("joy"), data);
  writer->SetInputData(data);
  writer->Modified();
  writer->SetFileName((folder.file("none") + "/joy.csv").c_str());
  writer->SetBits(0);
  writer->Write();
  EXPECT_NE(errors.first().find("it cannot be written"), std::string::npos) << errors.first();
  writer->SetFileName(file.c_str());
  writer->Write();
  EXPECT_EQ(readTextFile(file).rfind("region,", 0), 0u);
  EXPECT_FALSE(std::ifstream(mien::WholeFile::temporaryNameOf(file)).good());
}

TEST(FDTFiles, TheReaderNamesFileAndLine) {
  const TemporaryFolder folder;
  const std::string file = folder.file("table.csv");
  std::string text = readTextFile(smileFile);
  writeTextFile(file, text.replace(text.find("\n4,-0.009"), 9, "\n4,nan"));
  vtkNew<vtkFDTReader> reader;
  mien::PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(errors.first().rfind(file + ":7: region 4", 0), 0u) << errors.first();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfRows(), 0);
}
