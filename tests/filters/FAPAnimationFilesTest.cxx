#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "BoundaryCurveData.h"
#include "FAPText.h"
#include "PipelineErrors.h"
#include "SyntheticFace.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace {

void fill(vtkPolyData* data) {
  mien::writeFaceCurves(SyntheticFace::make(), data);
}

double largestDisplacement(vtkPolyData* curves) {
  return curves->GetPointData()->GetArray("Displacement")->GetMaxNorm();
}

TEST(FAPAnimationFiles, WhatOneFileLeavesOutIsSaidOfTheNextFileAnew) {
  const TemporaryFolder folder;
  for (const char* name : {"a.fap", "b.fap"})
    writeTextFile(folder.file(name), "2.1 eyes 25 1\n" + maskText({23}) + "\n0 100\n");
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<vtkFAPReader> reader;
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(0, curves);
  filter->SetFAPConnection(reader->GetOutputPort());
  vtkNew<vtkCallbackCommand> counter;
  int reports = 0;
  counter->SetClientData(&reports);
  counter->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  filter->AddObserver(vtkFAPAnimationFilter::IgnoredFAPsEvent, counter);
  int expected = 0;
  for (const char* name : {"a.fap", "b.fap", "a.fap"}) {
    reader->SetFileName(folder.file(name).c_str());
    filter->Update();
    EXPECT_EQ(filter->GetIgnoredFAPs(), std::vector<int>{23}) << name;
    EXPECT_EQ(reports, ++expected) << name;
    filter->SetFAP(31, expected);
    filter->Update();
    EXPECT_EQ(reports, expected) << "once per file";
  }
}

TEST(FAPAnimationFiles, AnEditedTableIsReadAgainAfterModified) {
  const TemporaryFolder folder;
  const std::string file = folder.file("table.json");
  const std::string text = readTextFile(MIEN_DATA_DIR "/animation/animation_table.json");
  const std::string name = "\"fap\": 31,";
  ASSERT_NE(text.find(name), std::string::npos);
  writeTextFile(file, text);
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(curves);
  filter->SetAnimationTableFileName(file);
  filter->SetFAP(31, 100.0);
  filter->Update();
  EXPECT_TRUE(filter->GetIgnoredFAPs().empty());
  const double before = largestDisplacement(filter->GetOutput());
  writeTextFile(file, "no table");
  filter->SetFAP(31, 101.0);
  filter->Update();
  EXPECT_GT(largestDisplacement(filter->GetOutput()), before) << "a value is no reason to look at the file";
  mien::PipelineErrors errors;
  errors.observe(filter);
  filter->Modified();
  filter->Update();
  EXPECT_NE(errors.first().find("table.json"), std::string::npos) << errors.first();
  writeTextFile(file, text);
  filter->Modified();
  filter->SetFAP(31, 100.0);
  filter->Update();
  EXPECT_EQ(largestDisplacement(filter->GetOutput()), before);
}

}  // namespace
