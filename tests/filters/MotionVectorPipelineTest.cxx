#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "ErrorCounter.h"
#include "FaceMotion.h"
#include "FacePipeline.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMotionVectorFilter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

namespace {

using SDDP = vtkStreamingDemandDrivenPipeline;

/// A triangle that has moved by `speed` mm per second along x, at the time that was asked for.
class MovingTriangle : public vtkPolyDataAlgorithm {
 public:
  static MovingTriangle* New();
  vtkTypeMacro(MovingTriangle, vtkPolyDataAlgorithm);
  double speed = 1.0;
  std::vector<double> steps = {0.0, 1.0, 2.0};

 protected:
  MovingTriangle() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
    const double range[] = {this->steps.front(), this->steps.back()};
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(SDDP::TIME_STEPS(), this->steps.data(), static_cast<int>(this->steps.size()));
    info->Set(SDDP::TIME_RANGE(), range, 2);
    return 1;
  }
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
    vtkInformation* info = outputs->GetInformationObject(0);
    const double time = info->Has(SDDP::UPDATE_TIME_STEP()) ? info->Get(SDDP::UPDATE_TIME_STEP()) : 0.0;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < 3; ++i) points->InsertNextPoint(this->speed * time + i, i * i, 0.0);
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    const vtkIdType ids[] = {0, 1, 2};
    output->AllocateExact(1, 3);
    output->SetPoints(points);
    output->InsertNextCell(VTK_TRIANGLE, 3, ids);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};
vtkStandardNewMacro(MovingTriangle);

/// The generic face in joy against itself, as two grids in pipelines.
struct FaceGrids {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkFAPAnimationFilter> animation;
  vtkNew<vtkPDEFaceFilter> moved, neutral;
  vtkNew<vtkMotionVectorFilter> filter;
  ErrorCounter errors{filter};

  FaceGrids() {
    animation->SetInputConnection(curves->GetOutputPort());
    animation->SetExpression("joy", 1.0);
    moved->SetInputConnection(animation->GetOutputPort());
    neutral->SetInputConnection(curves->GetOutputPort());
    filter->SetInputConnection(moved->GetOutputPort());
    filter->SetNeutralConnection(neutral->GetOutputPort());
  }
  double largest() {
    filter->Update();
    return filter->GetLargestMagnitude();
  }
};

double x(vtkMotionVectorFilter* filter) {
  return filter->GetOutput()->GetPointData()->GetArray("MotionVector")->GetComponent(0, 0);
}

TEST(MotionVectorPipeline, TakesGridsToo) {
  FaceGrids face;
  EXPECT_GT(face.largest(), 5.0);
  EXPECT_EQ(face.filter->GetOutput()->GetNumberOfPoints(), 56 * 41);
  EXPECT_NE(face.filter->GetOutput()->GetPointData()->GetArray("Normals"), nullptr);
  EXPECT_EQ(face.errors.count(), 0);
}

TEST(MotionVectorPipeline, PiecesHoldTheVectorsOfTheWhole) {
  FaceGrids whole, part;
  whole.filter->Update();
  std::map<std::vector<double>, std::set<std::vector<double>>> vectors;  // rows on seams start at one place
  const auto tuple = [](vtkPolyData* data, const char* name, vtkIdType i) {
    const double* values = data->GetPointData()->GetArray(name)->GetTuple(i);
    return std::vector<double>(values, values + 3);
  };
  const auto place = [](vtkPolyData* data, vtkIdType i) {
    const double* p = data->GetPoint(i);
    return std::vector<double>(p, p + 3);
  };
  for (vtkIdType i = 0; i < whole.filter->GetOutput()->GetNumberOfPoints(); ++i)
    vectors[place(whole.filter->GetOutput(), i)].insert(tuple(whole.filter->GetOutput(), "MotionVector", i));
  vtkIdType points = 0, vertices = 0;
  std::set<std::vector<double>> covered;
  for (int piece = 0; piece < 4; ++piece) {
    part.filter->UpdatePiece(piece, 4, 0);
    vtkPolyData* output = part.filter->GetOutput();
    EXPECT_LT(output->GetNumberOfPoints(), 56 * 41);
    points += output->GetNumberOfPoints();
    vertices += output->GetNumberOfVerts();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i) {
      ASSERT_EQ(vectors.count(place(output, i)), 1u);
      EXPECT_EQ(vectors[place(output, i)].count(tuple(output, "MotionVector", i)), 1u);
      covered.insert(place(output, i));
    }
  }
  EXPECT_GE(points, 56 * 41);
  EXPECT_EQ(vertices, 56 * 41) << "points that pieces share have one vertex";
  EXPECT_EQ(covered.size(), vectors.size()) << "every place is in some piece";
  EXPECT_EQ(part.errors.count(), 0);
}

TEST(MotionVectorPipeline, TheFitSeesAllPointsWhateverThePiece) {
  FaceGrids whole, part;
  whole.filter->RemoveRigidMotionOn();
  part.filter->RemoveRigidMotionOn();
  const double largest = whole.largest();
  part.filter->UpdatePiece(0, 3, 0);
  EXPECT_EQ(part.filter->GetLargestMagnitude(), largest);
  EXPECT_EQ(part.filter->GetOutput()->GetNumberOfPoints(), 56 * 41);
  part.filter->UpdatePiece(1, 3, 0);
  EXPECT_EQ(part.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(part.errors.count(), 0);
}

TEST(MotionVectorPipeline, RoutesTimeThroughBothPorts) {
  vtkNew<MovingTriangle> moved, neutral;
  moved->speed = 3.0;
  neutral->speed = 1.0;
  neutral->steps = {1.0, 4.0};
  vtkNew<vtkMotionVectorFilter> filter;
  filter->SetInputConnection(moved->GetOutputPort());
  filter->SetNeutralConnection(neutral->GetOutputPort());
  filter->UpdateInformation();
  vtkInformation* info = filter->GetOutputInformation(0);
  ASSERT_EQ(info->Length(SDDP::TIME_STEPS()), 4);  // 0, 1, 2, 4
  EXPECT_EQ(info->Get(SDDP::TIME_STEPS())[3], 4.0);
  EXPECT_EQ(info->Get(SDDP::TIME_RANGE())[1], 4.0);
  for (const double time : {1.0, 2.0, 4.0, 1.0, 0.0}) {
    filter->UpdateTimeStep(time);
    EXPECT_EQ(x(filter), 2.0 * time);
    EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  }
}

TEST(MotionVectorPipeline, TimeOfTheNeutralAloneIsPublished) {
  vtkNew<MovingTriangle> still, moving;
  still->Update();
  vtkNew<vtkMotionVectorFilter> filter;
  filter->SetInputData(still->GetOutput());
  filter->SetNeutralConnection(moving->GetOutputPort());
  filter->UpdateInformation();
  ASSERT_EQ(filter->GetOutputInformation(0)->Length(SDDP::TIME_STEPS()), 3);
  filter->UpdateTimeStep(2.0);
  EXPECT_EQ(x(filter), -2.0);
  filter->UpdateTimeStep(1.0);
  EXPECT_EQ(x(filter), -1.0);
}

TEST(MotionVectorPipeline, RunsAgainOnlyAfterAChange) {
  FaceGrids face;
  face.filter->Update();
  const vtkMTimeType first = face.filter->GetOutput()->GetMTime();
  face.filter->Update();
  EXPECT_EQ(face.filter->GetOutput()->GetMTime(), first);
  face.animation->SetExpression("joy", 0.5);
  face.filter->Update();
  const vtkMTimeType second = face.filter->GetOutput()->GetMTime();
  EXPECT_GT(second, first);
  face.filter->RemoveHeadRotationOn();
  face.filter->Update();
  EXPECT_GT(face.filter->GetOutput()->GetMTime(), second);
}

TEST(MotionVectorPipeline, KnownHeadRotationIsUndoneExactlyAndNothingElse) {
  FaceGrids face;
  const double joy = face.largest();
  face.moved->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  face.neutral->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  face.animation->SetFAP(49, 20000.0);
  EXPECT_GT(face.largest(), joy + 5.0);
  face.filter->RemoveHeadRotationOn();
  EXPECT_NEAR(face.largest(), joy, 1e-4);  // joy was measured in single precision
  face.animation->SetFAP(49, 0.0);
  EXPECT_NEAR(face.largest(), joy, 1e-4);  // expressions are no head motion
}

TEST(MotionVectorPipeline, AnAbortLeavesNoOutput) {
  FaceGrids face;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void*) { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = face.filter->AddObserver(vtkCommand::ProgressEvent, abort);
  face.filter->Update();
  EXPECT_EQ(face.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(face.errors.count(), 0);
  face.filter->RemoveObserver(tag);
  face.filter->SetAbortExecute(0);
  face.filter->Modified();
  EXPECT_GT(face.largest(), 5.0);
}

TEST(MotionVectorPipeline, EmptyAndWrongInputsAreErrorsWithoutOutput) {
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  for (const bool first : {true, false}) {
    vtkNew<vtkMotionVectorFilter> filter;
    ErrorCounter errors(filter);
    filter->SetInputData(first ? empty.Get() : sphere->GetOutput());
    filter->SetNeutralData(first ? sphere->GetOutput() : empty.Get());
    filter->Update();
    EXPECT_NE(errors.first().find(first ? "port 0" : "port 1"), std::string::npos) << errors.first();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
  vtkNew<vtkTable> table;
  vtkNew<vtkMotionVectorFilter> filter;
  ErrorCounter errors(filter);
  filter->SetInputData(table);
  filter->SetNeutralData(sphere->GetOutput());
  filter->Update();
  EXPECT_GT(errors.count(), 0);
}

TEST(FaceMotion, GivesTheFieldOfAFaceWithoutItsClosingColumn) {
  mien::FaceState joy;
  joy.expressions["joy"] = 1.0;
  mien::FaceMotion motion;
  motion.setStates(joy, mien::FaceMotion::neutralOf(joy));
  ASSERT_EQ(motion.update(), "");
  const mien::MotionField& field = motion.field();
  ASSERT_EQ(field.origins.rows(), 56 * 40);
  EXPECT_EQ(field.columns, 40);
  EXPECT_EQ(field.u.front(), 0.0);
  EXPECT_EQ(field.u.back(), 1.0);
  EXPECT_NEAR(field.v[39], 2.0 * M_PI * 39 / 40, 1e-15);
  EXPECT_EQ(field.seams.size(), 8u);
  EXPECT_EQ(field.patches.front()[0], 0);
  EXPECT_EQ(field.patches.back()[1], 8);
  for (size_t i = 0; i < field.ids.size(); ++i) {
    double moved[3], origin[3];
    motion.moved().grid()->GetPoint(field.ids[i], moved);
    motion.origin().grid()->GetPoint(field.ids[i], origin);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(field.vectors(i, axis), moved[axis] - origin[axis]);
  }
}

TEST(FaceMotion, ADeformationTableIsMotionToo) {
  mien::FaceState smile;
  smile.deformation.table = "smile";
  mien::FaceMotion motion;
  motion.setStates(smile, mien::FaceMotion::neutralOf(smile));
  ASSERT_EQ(motion.update(), "");
  EXPECT_GT(motion.field().magnitudes().maxCoeff(), 1.0);
}

TEST(FaceMotion, OutlineAndNormalsTurnBackWithTheHead) {
  mien::FaceState turned;
  turned.fapValues[49] = 30000.0;
  mien::FaceState both = turned;
  both.expressions["joy"] = 1.0;
  mien::FaceMotion motion, straight;
  motion.setHeadMotionRemoved(true);
  motion.setStates(both, turned);
  mien::FaceState joy;
  joy.expressions["joy"] = 1.0;
  straight.setStates(joy, mien::FaceMotion::neutralOf(joy));
  ASSERT_EQ(motion.update(), "");
  ASSERT_EQ(straight.update(), "");
  EXPECT_LT((motion.field().vectors - straight.field().vectors).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((motion.field().origins - straight.field().origins).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((motion.field().normals - straight.field().normals).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((motion.field().surface.vertices - straight.field().surface.vertices).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((motion.field().surfaceNormals - straight.field().surfaceNormals).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((motion.originFace().curves.points - straight.originFace().curves.points).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
