#include <gtest/gtest.h>

#include "FacePipeline.h"
#include "FaceStateText.h"
#include "PipelineErrors.h"
#include "TemporaryFolder.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFaceStateSource.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataWriter.h"

using namespace mien;

namespace {

const std::string demo = MIEN_DATA_DIR "/animation/demo.fap";

FaceState joyful() {
  FaceState state;
  state.expressions["joy"] = 1.0;
  state.deformation.table = "surprise";
  return state;
}

void expectSamePoints(vtkPointSet* one, vtkPointSet* other) {
  ASSERT_GT(one->GetNumberOfPoints(), 0);
  ASSERT_EQ(one->GetNumberOfPoints(), other->GetNumberOfPoints());
  for (vtkIdType i = 0; i < one->GetNumberOfPoints(); ++i)
    for (int k = 0; k < 3; ++k) ASSERT_EQ(one->GetPoint(i)[k], other->GetPoint(i)[k]) << i;
}

void expectFaceOf(const FaceState& state, vtkFaceStateSource* source) {
  FacePipeline pipeline;
  pipeline.setState(state);
  ASSERT_EQ(pipeline.update(), "");
  expectSamePoints(source->GetOutput(), pipeline.grid());
  expectSamePoints(source->GetCurves(), vtkPolyData::SafeDownCast(pipeline.shownCurves()->GetOutputDataObject(0)));
}

}  // namespace

TEST(FaceStateSource, GivesTheFaceOfItsState) {
  vtkNew<vtkFaceStateSource> source;
  source->Update();
  expectFaceOf({}, source);
  source->SetState(writeFaceState(joyful()));
  EXPECT_EQ(source->GetState(), writeFaceState(joyful()));
  source->Update();
  expectFaceOf(joyful(), source);
  EXPECT_TRUE(source->GetSurface()->GetPointData()->GetNormals());
  EXPECT_LT(source->GetSurface()->GetNumberOfPoints(), source->GetOutput()->GetNumberOfPoints() + 1);
}

TEST(FaceStateSource, RunsAgainOnlyWhenTheStateIsAnother) {
  vtkNew<vtkFaceStateSource> source;
  source->Update();
  const vtkMTimeType before = source->GetOutput()->GetMTime();
  source->SetState(source->GetState());
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetMTime(), before);
  source->SetState(writeFaceState(joyful()));
  source->Update();
  EXPECT_GT(source->GetOutput()->GetMTime(), before);
}

TEST(FaceStateSource, PiecesTogetherAreTheWhole) {
  vtkNew<vtkFaceStateSource> whole, first, second;
  whole->Update();
  first->UpdatePiece(0, 3, 0);
  second->UpdatePiece(1, 3, 0);
  expectSamePoints(first->GetOutput(), whole->GetOutput());
  EXPECT_EQ(second->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(second->GetSurface()->GetNumberOfPoints(), 0);
}

TEST(FaceStateSource, FollowsTheTimeOfItsAnimation) {
  FaceState state;
  state.fapFile = demo;
  vtkNew<vtkFaceStateSource> source;
  source->SetState(writeFaceState(state));
  source->UpdateInformation();
  vtkInformation* info = source->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 301);
  const double time = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), 139);
  source->UpdateTimeStep(time);
  state.frame = 139;
  expectFaceOf(state, source);
  EXPECT_EQ(source->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  source->SetState(writeFaceState({}));
  source->UpdateInformation();
  EXPECT_FALSE(source->GetOutputInformation(0)->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()));
}

TEST(FaceStateSource, TextThatIsNoStateChangesNothing) {
  vtkNew<vtkFaceStateSource> source;
  PipelineErrors errors;
  errors.observe(source);
  const std::string before = source->GetState();
  for (const char* text : {"", "{}", "[1]", "{\"mien_face_state\": 2, \"colour\": 1}", "{\"mien_face_state\": 99}"}) {
    source->SetState(text);
    EXPECT_EQ(source->GetState(), before) << text;
    EXPECT_NE(errors.first(), "") << text;
    errors.clear();
  }
}

TEST(FaceStateSource, LooksAgainAfterAFailure) {
  const TemporaryFolder folder;
  FaceState state;
  state.curvesFile = folder.file("face.vtp");
  vtkNew<vtkFaceStateSource> source;
  PipelineErrors errors;
  errors.observe(source);
  source->SetState(writeFaceState(state));
  for (int attempt = 0; attempt < 2; ++attempt) {
    errors.clear();
    source->Update();
    EXPECT_NE(errors.first().find("face.vtp: there is no such file"), std::string::npos) << errors.first();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  }
  vtkNew<vtkFaceStateSource> generic;
  generic->Update();
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(generic->GetCurves());
  writer->SetFileName(state.curvesFile.c_str());
  ASSERT_TRUE(writer->Write());
  errors.clear();
  source->Update();
  EXPECT_EQ(errors.first(), "");
  expectSamePoints(source->GetOutput(), generic->GetOutput());
}

TEST(FaceStateSource, ValuesOutOfRangeAreRefused) {
  for (void (*spoil)(FaceState&) : {+[](FaceState& s) { s.rows = -5; }, +[](FaceState& s) { s.surface.modes = 999; },
                                    +[](FaceState& s) { s.expressions["glee"] = 1.0; }}) {
    FaceState state;
    spoil(state);
    vtkNew<vtkFaceStateSource> source;
    PipelineErrors errors;
    errors.observe(source);
    source->SetState(writeFaceState(state));
    source->Update();
    EXPECT_NE(errors.first(), "");
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(FaceStateSource, CanBeAborted) {
  FaceState state;
  state.rows = 2000;
  state.columns = 500;
  vtkNew<vtkFaceStateSource> source;
  source->SetState(writeFaceState(state));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = source->AddObserver(vtkCommand::ProgressEvent, stop);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  source->RemoveObserver(tag);
  source->SetAbortExecute(0);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 2000 * 501);
}
