#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkMotionVectorFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

namespace {

vtkSmartPointer<vtkPolyData> sphereData() {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(80.0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// The sphere with points that a formula moves.
template <typename Shift>
vtkSmartPointer<vtkPolyData> shifted(vtkPolyData* data, Shift&& shift) {
  auto moved = vtkSmartPointer<vtkPolyData>::New();
  moved->DeepCopy(data);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i) {
    double p[3];
    moved->GetPoint(i, p);
    shift(i, p);
    moved->GetPoints()->SetPoint(i, p);
  }
  return moved;
}

void turnAndShift(vtkIdType, double* p) {
  const double angle = M_PI / 6.0, x = p[0], z = p[2];
  p[0] = std::cos(angle) * x + std::sin(angle) * z + 5.0;
  p[2] = -std::sin(angle) * x + std::cos(angle) * z - 3.0;
}

vtkDataArray* array(vtkMotionVectorFilter* filter, const char* name) {
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

std::string updateAndCatch(vtkMotionVectorFilter* filter) {
  std::string message;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&message);
  observer->SetCallback([](vtkObject*, unsigned long, void* kept, void* text) {
    *static_cast<std::string*>(kept) += static_cast<const char*>(text);
  });
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  return message;
}

}  // namespace

TEST(MotionVectorFilter, IsTheDifferenceOfTheSurfacesExactly) {
  const auto neutral = sphereData();
  const auto moved = shifted(neutral, [](vtkIdType i, double* p) {
    p[0] += 0.1 * static_cast<double>(i);
    p[1] -= 0.3 * static_cast<double>(i % 7);
    p[2] += 1.0 / 3.0;
  });
  vtkNew<vtkMotionVectorFilter> filter;
  filter->SetInputData(moved);
  filter->SetNeutralData(neutral);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfVerts(), neutral->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < neutral->GetNumberOfPoints(); ++i) {
    double p[3], q[3], origin[3], vector[3], projected[2];
    neutral->GetPoint(i, p);
    moved->GetPoint(i, q);
    filter->GetOutput()->GetPoint(i, origin);
    array(filter, "MotionVector")->GetTuple(i, vector);
    array(filter, "ProjectedVector")->GetTuple(i, projected);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(vector[c], q[c] - p[c]);
      EXPECT_EQ(origin[c], p[c]);
    }
    EXPECT_EQ(projected[0], vector[0]);
    EXPECT_EQ(projected[1], vector[1]);
    const double magnitude = array(filter, "Magnitude")->GetTuple1(i);
    EXPECT_NEAR(magnitude, std::hypot(vector[0], vector[1], vector[2]), 1e-13);
    largest = std::max(largest, magnitude);
  }
  EXPECT_NEAR(filter->GetLargestMagnitude(), largest, 1e-12);
}

TEST(MotionVectorFilter, OneSurfaceTwiceGivesZero) {
  vtkNew<vtkMotionVectorFilter> filter;
  const auto neutral = sphereData();
  filter->SetInputData(neutral);
  filter->SetNeutralData(neutral);
  filter->Update();
  EXPECT_EQ(filter->GetLargestMagnitude(), 0.0);
  EXPECT_EQ(array(filter, "Magnitude")->GetRange()[1], 0.0);
}

TEST(MotionVectorFilter, RemovesTheMotionOfTheHead) {
  vtkNew<vtkMotionVectorFilter> filter;
  const auto neutral = sphereData();
  filter->SetInputData(shifted(neutral, turnAndShift));
  filter->SetNeutralData(neutral);
  filter->Update();
  EXPECT_GT(filter->GetLargestMagnitude(), 30.0);
  filter->RemoveRigidMotionOn();
  filter->Update();
  EXPECT_LT(filter->GetLargestMagnitude(), 1e-10);
  EXPECT_NEAR(filter->GetRigidAngle(), 30.0, 1e-9);
  EXPECT_NEAR(filter->GetRigidRotation()[2], 0.5, 1e-12);
  EXPECT_NEAR(filter->GetRigidTranslation()[0], 5.0, 1e-10);
}

TEST(MotionVectorFilter, ProjectsAlongTheView) {
  vtkNew<vtkMotionVectorFilter> filter;
  const auto neutral = sphereData();
  filter->SetInputData(shifted(neutral, [](vtkIdType, double* p) {
    p[1] += 2.0;
    p[2] += 3.0;
    p[0] += 7.0;
  }));
  filter->SetNeutralData(neutral);
  filter->SetViewDirection(5.0, 0.0, 0.0);
  filter->Update();
  double projected[2];
  array(filter, "ProjectedVector")->GetTuple(4, projected);
  EXPECT_NEAR(projected[0], -3.0, 1e-12);
  EXPECT_NEAR(projected[1], 2.0, 1e-12);
}

TEST(MotionVectorFilter, RefusesOtherTopologyAndSaysWhich) {
  const auto neutral = sphereData();
  vtkNew<vtkSphereSource> other;
  other->SetThetaResolution(11);
  other->Update();
  vtkNew<vtkMotionVectorFilter> filter;
  filter->SetNeutralData(neutral);
  filter->SetInputData(other->GetOutput());
  EXPECT_NE(updateAndCatch(filter).find("points and the neutral one"), std::string::npos);
  vtkNew<vtkMotionVectorFilter> reversed;
  auto mirrored = shifted(neutral, [](vtkIdType, double*) {});
  mirrored->BuildCells();
  mirrored->ReverseCell(3);
  reversed->SetInputData(mirrored);
  reversed->SetNeutralData(neutral);
  EXPECT_NE(updateAndCatch(reversed).find("cell 3 joins other points"), std::string::npos);
  vtkNew<vtkMotionVectorFilter> blind;
  blind->SetInputData(neutral);
  blind->SetNeutralData(neutral);
  blind->SetViewUp(0.0, 0.0, 2.0);
  EXPECT_NE(updateAndCatch(blind).find("view up"), std::string::npos);
}
