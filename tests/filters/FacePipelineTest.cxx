#include "FacePipeline.h"

#include "vtkBoundaryCurveReader.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

#include <gtest/gtest.h>

namespace {

using mien::FacePipeline;
using mien::FaceState;

TEST(FacePipeline, DefaultStateShowsTheGenericFace) {
  FacePipeline pipeline;
  EXPECT_EQ(pipeline.updateNeutralCurves(), "");
  EXPECT_EQ(pipeline.pointsPerCurve(), 40);
  ASSERT_EQ(pipeline.update(), "");
  EXPECT_EQ(pipeline.face()->GetOutput()->GetNumberOfPoints(), 56 * 41);
}

TEST(FacePipeline, EveryPropertyReachesItsFilter) {
  FaceState state;
  state.surface.scheme = "derivative";
  state.surface.smoothing = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  state.surface.modes = 7;
  state.surface.remainder = false;
  state.surface.derivativeStrength = 0.5;
  state.rows = 83;
  state.columns = 24;
  state.uniformRows = true;
  state.doublePrecision = true;
  FacePipeline pipeline;
  pipeline.setState(state);
  ASSERT_EQ(pipeline.update(), "");
  vtkPDEFaceFilter* face = pipeline.face();
  EXPECT_EQ(face->GetScheme(), "derivative");
  for (int patch = 0; patch < 9; ++patch) EXPECT_EQ(face->GetSmoothing(patch), patch + 1.0);
  EXPECT_EQ(face->GetNumberOfModes(), 7);
  EXPECT_FALSE(face->GetRemainder());
  EXPECT_EQ(face->GetDerivativeStrength(), 0.5);
  EXPECT_TRUE(face->GetUniformRows());
  EXPECT_EQ(face->GetOutput()->GetNumberOfPoints(), 83 * 25);
  EXPECT_EQ(face->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(FacePipeline, SettingTheSameStateAgainComputesNothing) {
  FacePipeline pipeline;
  ASSERT_EQ(pipeline.update(), "");
  const auto before = pipeline.face()->GetOutput()->GetMTime();
  pipeline.setState(FaceState());
  ASSERT_EQ(pipeline.update(), "");
  EXPECT_EQ(pipeline.face()->GetOutput()->GetMTime(), before);
}

TEST(FacePipeline, ErrorsComeBackAsOneSentenceAndCanBeMended) {
  FacePipeline pipeline;
  FaceState state;
  state.curvesFile = "/no/such/face.vtp";
  pipeline.setState(state);
  EXPECT_EQ(pipeline.update().rfind("/no/such/face.vtp: ", 0), 0u) << pipeline.update();
  state = FaceState();
  state.surface.modes = 99;
  pipeline.setState(state);
  EXPECT_EQ(pipeline.update(), "N = 99 is outside 0 .. 20 (curves have 40 points)");
  EXPECT_EQ(pipeline.update(), "N = 99 is outside 0 .. 20 (curves have 40 points)");
  pipeline.setState(FaceState());
  EXPECT_EQ(pipeline.update(), "");
}

}  // namespace
