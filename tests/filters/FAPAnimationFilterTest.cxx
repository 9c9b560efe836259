#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "BoundaryCurveData.h"
#include "FAPTableData.h"
#include "FaceLayout.h"
#include "SyntheticFace.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkTableAlgorithm.h"

namespace {

vtkNew<vtkPolyData>& fill(vtkNew<vtkPolyData>& data) {
  mien::writeFaceCurves(SyntheticFace::make(), data);
  return data;
}

/// The error messages of a filter; while it watches, nothing is printed.
class Errors {
 public:
  explicit Errors(vtkAlgorithm* filter) : filter_(filter) {
    observer_->SetClientData(&messages_);
    observer_->SetCallback([](vtkObject*, unsigned long, void* kept, void* text) {
      static_cast<std::vector<std::string>*>(kept)->push_back(static_cast<const char*>(text));
    });
    filter->AddObserver(vtkCommand::ErrorEvent, observer_);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer_);
  }
  std::string all() const {
    std::string text;
    for (const std::string& message : messages_) text += message;
    return text;
  }

 private:
  vtkAlgorithm* filter_;
  std::vector<std::string> messages_;
  vtkNew<vtkCallbackCommand> observer_;
};

double furthest(vtkPolyData* curves) {
  double distance = 0.0;
  vtkDataArray* shift = curves->GetPointData()->GetArray("Displacement");
  for (vtkIdType i = 0; shift && i < shift->GetNumberOfTuples(); ++i) {
    const double* s = shift->GetTuple3(i);
    distance = std::max(distance, std::sqrt(s[0] * s[0] + s[1] * s[1] + s[2] * s[2]));
  }
  return distance;
}

/// A source of FAP frames in time: FAP 31 is 100 times the time that was asked for.
class FrameSource : public vtkTableAlgorithm {
 public:
  static FrameSource* New();
  vtkTypeMacro(FrameSource, vtkTableAlgorithm);
  int requests = 0;

 protected:
  FrameSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
    const double steps[] = {0.0, 1.0, 2.0}, range[] = {0.0, 2.0};
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps, 3);
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
    vtkInformation* info = outputs->GetInformationObject(0);
    const auto key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
    const double time = info->Has(key) ? info->Get(key) : 0.0;
    mien::FAPFrame frame;
    frame.setValue(31, 100.0 * time);
    vtkTable* table = vtkTable::GetData(outputs);
    mien::writeFAPFrame(frame, table);
    table->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    ++this->requests;
    return 1;
  }
};
vtkStandardNewMacro(FrameSource);

}  // namespace

TEST(FAPAnimationFilter, PassesTheNeutralCurvesAndAllArrays) {
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(curves);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), curves->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(output->GetPoint(i)[axis], curves->GetPoint(i)[axis]);
  EXPECT_EQ(furthest(output), 0.0);
  for (const char* name : {"CurveId", "CurveName"}) EXPECT_TRUE(output->GetCellData()->HasArray(name)) << name;
  for (const char* name : {"Units", "FeatureId", "FeatureCurve", "FeatureV", "Pupils"})
    EXPECT_TRUE(output->GetFieldData()->HasArray(name)) << name;
  EXPECT_NEAR(filter->GetFAPUnit("ES"), 63.0, 1e-12);
  EXPECT_NEAR(filter->GetFAPUnit("IRISD"), 8.0, 0.1);
  EXPECT_EQ(filter->GetFAPUnit("AU"), 0.0);
}

TEST(FAPAnimationFilter, AddsValuesExpressionsAndTheTable) {
  vtkNew<vtkPolyData> curves;
  fill(curves);
  mien::FAPFrame frame;
  frame.setValue(31, 40.0);
  vtkNew<vtkTable> table;
  mien::writeFAPFrame(frame, table);
  vtkNew<vtkFAPAnimationFilter> filter, alone;
  filter->SetInputData(0, curves);
  filter->SetInputData(1, table);
  filter->SetFAP(31, 60.0);
  alone->SetInputData(curves);
  alone->SetFAP(31, 100.0);
  for (auto* each : {filter.Get(), alone.Get()}) {
    each->SetExpression("joy", 0.5);
    each->Update();
  }
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(filter->GetOutput()->GetPoint(i)[axis], alone->GetOutput()->GetPoint(i)[axis], 1e-12);
  EXPECT_GT(furthest(filter->GetOutput()), 1.0);
  filter->ClearFAPs();
  filter->ClearExpressions();
  filter->Update();
  const double expected = 40.0 * filter->GetFAPUnit("ENS") / 1024.0;
  EXPECT_GT(furthest(filter->GetOutput()), 0.8 * expected);
  EXPECT_LE(furthest(filter->GetOutput()), expected + 1e-12);
}

TEST(FAPAnimationFilter, TakesTheLinesInAnyOrder) {
  vtkNew<vtkPolyData> curves, shuffled;
  fill(curves);
  shuffled->DeepCopy(curves);
  vtkNew<vtkCellArray> lines;
  vtkDataArray* ids = shuffled->GetCellData()->GetArray("CurveId");
  vtkNew<vtkIdList> line;
  for (vtkIdType i = 0; i < curves->GetNumberOfLines(); ++i) {
    const vtkIdType from = curves->GetNumberOfLines() - 1 - i;
    curves->GetLines()->GetCellAtId(from, line);
    lines->InsertNextCell(line);
    ids->SetTuple1(i, curves->GetCellData()->GetArray("CurveId")->GetTuple1(from));
  }
  shuffled->SetLines(lines);
  vtkNew<vtkFAPAnimationFilter> filter, other;
  filter->SetInputData(curves);
  other->SetInputData(shuffled);
  for (auto* each : {filter.Get(), other.Get()}) {
    each->SetExpression("surprise", 1.0);
    each->Update();
  }
  for (vtkIdType i = 0; i < curves->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(filter->GetOutput()->GetPoint(i)[axis], other->GetOutput()->GetPoint(i)[axis]);
}

TEST(FAPAnimationFilter, RunsAgainOnlyWhenSomethingChanged) {
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(curves);
  filter->SetFAP(31, 100.0);
  filter->Update();
  const vtkMTimeType first = filter->GetOutput()->GetMTime();
  filter->SetFAP(31, 100.0);
  filter->SetExpression("joy", 0.0);
  filter->SetAnimationTableFileName("");
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetMTime(), first);
  filter->SetFAP(31, 101.0);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetMTime(), first);
  const double before = furthest(filter->GetOutput());
  curves->Modified();
  filter->Update();
  EXPECT_EQ(furthest(filter->GetOutput()), before);
}

TEST(FAPAnimationFilter, PublishesAndRoutesTime) {
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<FrameSource> source;
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(0, curves);
  filter->SetFAPConnection(source->GetOutputPort());
  filter->UpdateInformation();
  vtkInformation* info = filter->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  double previous = -1.0;
  for (double time : {0.0, 1.0, 2.0}) {
    filter->UpdateTimeStep(time);
    EXPECT_GT(furthest(filter->GetOutput()), previous) << time;
    EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
    previous = furthest(filter->GetOutput());
  }
  filter->UpdateTimeStep(1.0);
  EXPECT_NEAR(furthest(filter->GetOutput()), 0.5 * previous, 1e-9);
  const int requests = source->requests;
  filter->UpdateTimeStep(1.0);
  EXPECT_EQ(source->requests, requests);
}

TEST(FAPAnimationFilter, RefusesWrongInputWithoutOutput) {
  vtkNew<vtkPolyData> curves, empty;
  fill(curves);
  vtkNew<vtkTable> none;
  const auto refused = [&](vtkPolyData* face, vtkTable* table, const char* tableFile) {
    vtkNew<vtkFAPAnimationFilter> filter;
    filter->SetInputData(0, face);
    if (table) filter->SetInputData(1, table);
    filter->SetAnimationTableFileName(tableFile);
    Errors errors(filter);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    return errors.all();
  };
  EXPECT_NE(refused(empty, nullptr, "").find("there are no lines"), std::string::npos);
  EXPECT_NE(refused(curves, none, "").find("0 rows"), std::string::npos);
  EXPECT_NE(refused(curves, nullptr, "/nowhere.json").find("/nowhere.json: it cannot be opened"), std::string::npos);
  vtkNew<vtkPolyData> bare;
  bare->DeepCopy(curves);
  bare->GetFieldData()->RemoveArray("Pupils");
  EXPECT_NE(refused(bare, nullptr, "").find("no pupils"), std::string::npos);
}

TEST(FAPAnimationFilter, RefusesValuesOutOfRange) {
  vtkNew<vtkFAPAnimationFilter> filter;
  Errors errors(filter);
  filter->SetFAP(2, 10.0);
  filter->SetFAP(69, 10.0);
  filter->SetFAP(31, std::nan(""));
  filter->SetExpression("boredom", 0.5);
  filter->SetExpression("joy", 1.5);
  for (const char* part : {"FAP 2 has no value", "FAP 69 has no value", "not finite", "boredom", "1.5"})
    EXPECT_NE(errors.all().find(part), std::string::npos) << part;
  EXPECT_EQ(filter->GetFAP(31), 0.0);
  EXPECT_EQ(filter->GetExpression("joy"), 0.0);
}

TEST(FAPAnimationFilter, AnAbortLeavesNoOutput) {
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(curves);
  filter->SetFAP(31, 100.0);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, abort);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->RemoveObserver(tag);
  filter->Modified();
  filter->Update();
  EXPECT_GT(furthest(filter->GetOutput()), 0.0);
}

TEST(FAPAnimationFilter, TellsIgnoredFapsOnce) {
  vtkNew<vtkPolyData> curves;
  fill(curves);
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(curves);
  int events = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&events);
  count->SetCallback([](vtkObject*, unsigned long, void* counter, void*) { ++*static_cast<int*>(counter); });
  filter->AddObserver(vtkFAPAnimationFilter::IgnoredFAPsEvent, count);
  for (double value : {10.0, 20.0}) {
    filter->SetFAP(43, value);
    filter->Update();
  }
  EXPECT_EQ(events, 1);
  EXPECT_EQ(filter->GetIgnoredFAPs(), std::vector<int>{43});
}

TEST(FAPAnimationFilter, ListsTheSixExpressions) {
  EXPECT_EQ(vtkFAPAnimationFilter::GetExpressionNames(),
            (std::vector<std::string>{"joy", "sadness", "anger", "fear", "disgust", "surprise"}));
  for (const std::string& name : vtkFAPAnimationFilter::GetExpressionNames())
    EXPECT_FALSE(vtkFAPAnimationFilter::GetExpressionDefinition(name).empty());
  EXPECT_GT(vtkFAPAnimationFilter::GetExpressionFAP("joy", 53), 0.0);
}

TEST(FAPAnimationFilter, ATurnedHeadIsRigidAndIsReadAgain) {
  vtkNew<vtkPolyData> input, copy;
  fill(input);
  vtkNew<vtkFAPAnimationFilter> filter;
  filter->SetInputData(input);
  filter->SetFAP(48, 250000.0);  // 2.5 rad: upside down, so that the heights alone would be refused
  filter->SetFAP(50, 90000.0);
  filter->Update();
  EXPECT_EQ(filter->GetIgnoredFAPs(), std::vector<int>{});
  EXPECT_EQ(input->GetFieldData()->GetArray("HeadRotation"), nullptr);
  mien::FaceCurves face, turned;
  ASSERT_EQ(mien::readFaceCurves(input, face), "");
  ASSERT_EQ(mien::readFaceCurves(filter->GetOutput(), turned), "");
  const auto distance = [](const mien::FaceCurves& f, int i) {
    return (f.curves.points.row(i) - f.leftPupil.transpose()).norm();
  };
  for (int i = 0; i < face.curves.points.rows(); ++i) EXPECT_NEAR(distance(turned, i), distance(face, i), 1e-10);
  EXPECT_GT((turned.leftPupil - face.leftPupil).norm(), 30.0);
  copy->DeepCopy(filter->GetOutput());
  copy->GetFieldData()->RemoveArray("HeadRotation");
  EXPECT_NE(mien::readFaceCurves(copy, turned).find("without crossing"), std::string::npos);
}

// A file whose writer merged equal points: the closed lips would move as one.
TEST(FAPAnimationFilter, LipsThatSharePointsOpen) {
  vtkNew<vtkPolyData> merged, separate;
  fill(merged);
  fill(separate);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdList> ids;
  int shared = 0;
  for (vtkIdType line = 0; line < merged->GetNumberOfLines(); ++line) {
    merged->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType i = 0; line == mien::FaceLayout::lowerLip && i < ids->GetNumberOfIds(); ++i) {
      double lower[3], upper[3];
      const vtkIdType above = ids->GetId(i) - 40;
      merged->GetPoint(ids->GetId(i), lower);
      merged->GetPoint(above, upper);
      if (!std::equal(lower, lower + 3, upper)) continue;
      ids->SetId(i, above);
      ++shared;
    }
    lines->InsertNextCell(ids);
  }
  ASSERT_GT(shared, 5);
  merged->SetLines(lines);
  mien::ClosedCurves moved[2];
  for (const int i : {0, 1}) {
    vtkNew<vtkFAPAnimationFilter> filter;
    filter->SetInputData(i == 0 ? merged : separate);
    filter->SetFAP(3, 300.0);
    filter->SetFAP(51, -100.0);
    filter->Update();
    ASSERT_EQ(mien::readClosedCurves(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0)), moved[i]), "");
  }
  EXPECT_EQ(moved[0].points, moved[1].points);
  const int lower = mien::FaceLayout::lowerLip * 40 + 20;
  EXPECT_GT(std::abs(moved[0].points(lower, 1) - moved[0].points(lower - 40, 1)), 1.0);
}
