#include <gtest/gtest.h>

#include <limits>

#include "FAPTableData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

using namespace mien;

namespace {

FAPFrame filledFrame() {
  FAPFrame frame;
  frame.number = 12.5;
  frame.viseme = {1, 2, 3, 1};
  frame.expression = {4, 50, 6, 7, 1, 0};
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) frame.setValue(fap, fap / 3.0);
  return frame;
}

void addColumn(vtkTable* table, const char* name, double value) {
  vtkNew<vtkDoubleArray> column;
  column->SetName(name);
  column->InsertNextValue(value);
  table->AddColumn(column);
}

}  // namespace

TEST(FAPTableData, AFrameComesBackFromItsTable) {
  const FAPFrame frame = filledFrame();
  vtkNew<vtkTable> table;
  writeFAPFrame(frame, table);
  EXPECT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetNumberOfColumns(), 1 + 4 + 6 + 66);
  FAPFrame read;
  ASSERT_EQ(readFAPFrame(table, 0, read), "");
  EXPECT_EQ(read.number, 12.5);
  EXPECT_EQ(read.viseme.blend, 3);
  EXPECT_EQ(read.expression.intensity1, 50);
  EXPECT_EQ(read.expression.select2, 6);
  EXPECT_EQ(read.expression.initialFace, 1);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) EXPECT_EQ(read.value(fap), frame.value(fap));
}

TEST(FAPTableData, MissingColumnsAreZero) {
  vtkNew<vtkTable> table;
  addColumn(table, "FAP53", 200);
  FAPFrame read = filledFrame();
  ASSERT_EQ(readFAPFrame(table, 0, read), "");
  EXPECT_EQ(read.value(53), 200);
  EXPECT_EQ(read.value(54), 0);
  EXPECT_EQ(read.viseme.select1, 0);
}

TEST(FAPTableData, RefusalsNameTheColumnAndKeepTheFrame) {
  vtkNew<vtkTable> table;
  addColumn(table, "FAP7", std::numeric_limits<double>::quiet_NaN());
  FAPFrame read = filledFrame();
  EXPECT_NE(readFAPFrame(table, 0, read).find("FAP7"), std::string::npos);
  EXPECT_EQ(read.value(53), 53 / 3.0);
  EXPECT_NE(readFAPFrame(table, 1, read).find("row 1"), std::string::npos);
  EXPECT_NE(readFAPFrame(nullptr, 0, read), "");
}

TEST(FAPTableData, TextColumnsAreRefused) {
  vtkNew<vtkTable> table;
  vtkNew<vtkStringArray> text;
  text->SetName("FAP9");
  text->InsertNextValue("loud");
  table->AddColumn(text);
  FAPFrame read;
  EXPECT_NE(readFAPFrame(table, 0, read).find("FAP9"), std::string::npos);
}
