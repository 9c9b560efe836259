#include <gtest/gtest.h>

#include "CurveEdit.h"
#include "FaceFiles.h"
#include "FaceLayout.h"
#include "FacePipeline.h"
#include "PipelineErrors.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCurveEditFilter.h"

using namespace mien;

namespace {

FaceCurves faceOf(vtkAlgorithm* algorithm) {
  FaceCurves face;
  EXPECT_EQ(readFaceCurves(vtkPolyData::SafeDownCast(algorithm->GetOutputDataObject(0)), face), "");
  return face;
}

}  // namespace

TEST(CurveEditFilter, WithoutEditsTheCurvesAreTheSame) {
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkCurveEditFilter> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPoints(), reader->GetOutput()->GetPoints());
}

TEST(CurveEditFilter, EditsMoveTheOutputAndCanBeTakenBack) {
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkCurveEditFilter> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->AddEdit("C15", M_PI, 0.0, 0.0, 5.0, 30.0, 1, false);
  filter->Update();
  const FaceCurves edited = faceOf(filter), neutral = genericFace();
  EXPECT_NEAR(edited.curves.curve(14)(20, 2) - neutral.curves.curve(14)(20, 2), 5.0, 1e-12);
  EXPECT_EQ(edited.features.size(), neutral.features.size());
  const auto time = filter->GetMTime();
  filter->SetEdits(filter->GetEdits());
  EXPECT_EQ(filter->GetMTime(), time) << "the same edits are no change";
  filter->RemoveAllEdits();
  filter->Update();
  EXPECT_EQ(faceOf(filter).curves.points, neutral.curves.points);
}

TEST(CurveEditFilter, ErrorsNameEditAndCurves) {
  vtkNew<vtkBoundaryCurveReader> reader;
  vtkNew<vtkCurveEditFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputConnection(reader->GetOutputPort());
  filter->AddEdit("C6", M_PI, 0.0, 60.0, 0.0, 30.0, 0, false);
  filter->Update();
  EXPECT_NE(errors.first().find("edit 1 (C6)"), std::string::npos) << errors.first();
  EXPECT_NE(errors.first().find("C5"), std::string::npos) << errors.first();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  errors.clear();
  filter->RemoveAllEdits();
  filter->AddEdit("C40", M_PI, 0.0, 1.0, 0.0, 30.0, 0, false);
  filter->Update();
  EXPECT_NE(errors.first().find("no such curve"), std::string::npos) << errors.first();
}

TEST(CurveEditFilter, TheStateOfAFaceDrivesIt) {
  FacePipeline pipeline;
  FaceState state;
  CurveEdit edit;
  edit.curve = FaceLayout::curveIndex("C15");
  edit.v = M_PI;
  edit.move = {0.0, 0.0, 4.0};
  state.edits = {edit};
  pipeline.setState(state);
  ASSERT_EQ(pipeline.updateCurves(), "");
  EXPECT_NEAR(faceOf(pipeline.curves()).curves.curve(14)(20, 2) - genericFace().curves.curve(14)(20, 2), 4.0, 1e-9);
  state.edits[0].move = {0.0, 80.0, 0.0};
  pipeline.setState(state);
  EXPECT_NE(pipeline.updateCurves().find("C15"), std::string::npos);
  pipeline.setState({});
  ASSERT_EQ(pipeline.updateCurves(), "");
  EXPECT_EQ(faceOf(pipeline.curves()).curves.points, genericFace().curves.points);
}
