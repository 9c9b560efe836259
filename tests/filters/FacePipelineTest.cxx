#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "FacePipeline.h"
#include "NamedTables.h"
#include "TableText.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"

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

/// Three frames that open the left lid, numbered 10, 20, 30 at 2 frames per second.
std::string writeAnimation(const TemporaryFolder& folder) {
  const std::string name = folder.file("lids.fap");
  std::ostringstream file;
  file << "2.1 lids 2 3\n";
  for (int i = 0; i < 3; ++i) {
    for (int fap = 1; fap <= 68; ++fap) file << (fap == 19 ? "1 " : "0 ");
    file << "\n" << 10 * (i + 1) << " " << 100 * i << "\n";
  }
  writeTextFile(name, file.str());
  return name;
}

FaceState animated(const std::string& file, FaceState::FrameChoice choice, double frame) {
  FaceState state;
  state.fapFile = file;
  state.frameChoice = choice;
  state.frame = frame;
  return state;
}

double largestDisplacement(FacePipeline& pipeline, const FaceState& state) {
  pipeline.setState(state);
  EXPECT_EQ(pipeline.update(), "");
  vtkPolyData* curves = vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0));
  return curves->GetPointData()->GetArray("Displacement")->GetMaxNorm();
}

TEST(FacePipeline, AFrameIsChosenByIndexNumberOrTime) {
  using Choice = FaceState::FrameChoice;
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);
  FacePipeline pipeline;
  EXPECT_EQ(largestDisplacement(pipeline, animated(file, Choice::Index, 0)), 0.0);
  const double one = largestDisplacement(pipeline, animated(file, Choice::Index, 1));
  const double two = largestDisplacement(pipeline, animated(file, Choice::Index, 2));
  EXPECT_GT(one, 0.1);
  EXPECT_GT(two, 1.5 * one);
  EXPECT_EQ(largestDisplacement(pipeline, animated(file, Choice::Number, 20)), one);
  EXPECT_EQ(largestDisplacement(pipeline, animated(file, Choice::Time, 0.99)), one);
  EXPECT_EQ(largestDisplacement(pipeline, animated(file, Choice::Time, 1.0)), two);
  EXPECT_EQ(largestDisplacement(pipeline, FaceState()), 0.0);
}

TEST(FacePipeline, OwnFAPsAddToThoseOfTheFile) {
  FacePipeline pipeline;
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);
  const double two = largestDisplacement(pipeline, animated(file, FaceState::FrameChoice::Index, 2));
  FaceState state = animated(file, FaceState::FrameChoice::Index, 1);
  state.fapValues[19] = 100.0;
  EXPECT_EQ(largestDisplacement(pipeline, state), two);
}

TEST(FacePipeline, AnExpressionMovesTheFaceInProportion) {
  FacePipeline pipeline;
  FaceState state;
  state.expressions["joy"] = 1.0;
  const double full = largestDisplacement(pipeline, state);
  state.expressions["joy"] = 0.1;
  const double tenth = largestDisplacement(pipeline, state);
  EXPECT_GT(full, 2.0);
  EXPECT_GT(tenth, 0.02 * full);
  EXPECT_LT(tenth, 0.5 * full);
  EXPECT_EQ(largestDisplacement(pipeline, FaceState()), 0.0);
}

TEST(FacePipeline, ATableBendsTheFaceInProportionAndAnUnknownOneIsNamed) {
  FacePipeline pipeline;
  FaceState state;
  state.doublePrecision = true;
  state.deformation.table = "joy";
  const auto moved = [&](double strength) {
    state.deformation.strength = strength;
    pipeline.setState(state);
    EXPECT_EQ(pipeline.update(), "");
    double corner[3];
    pipeline.grid()->GetPoint(42 * 41 + 17, corner);  // beside the mouth
    return corner[1] - pipeline.face()->GetOutput()->GetPoint(42 * 41 + 17)[1];
  };
  const double full = moved(1.0);
  EXPECT_GT(full, 3.0);
  EXPECT_NEAR(moved(0.5), 0.5 * full, 1e-9);
  state.deformation.table = "smug";
  pipeline.setState(state);
  EXPECT_NE(pipeline.update().find("smug: it cannot be opened"), std::string::npos);
  state.deformation.table.clear();
  pipeline.setState(state);
  EXPECT_EQ(pipeline.update(), "");
  EXPECT_EQ(pipeline.grid()->GetPoint(42 * 41 + 17)[1], pipeline.face()->GetOutput()->GetPoint(42 * 41 + 17)[1]);
}

/// A curve is a row of the surface: the 27 intervals of its rows lie on the curves when each has two rows.
TEST(FacePipeline, CurvesGoWhereTheTableTakesTheSurface) {
  for (const double yaw : {0.0, 60000.0}) {
    FacePipeline pipeline;
    FaceState state;
    state.doublePrecision = true;
    state.columns = 40;
    state.deformation.table = "surprise";
    state.fapValues[49] = yaw;
    pipeline.setState(state);
    ASSERT_EQ(pipeline.update(), "");
    auto* before = vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0));
    auto* after = vtkPolyData::SafeDownCast(pipeline.shownCurves()->GetOutputDataObject(0));
    ASSERT_EQ(before->GetNumberOfPoints(), after->GetNumberOfPoints());
    double largest = 0.0, worst = 0.0;
    for (vtkIdType i = 0; i < before->GetNumberOfPoints(); ++i) {
      const Eigen::Vector3d from(before->GetPoint(i)), to(after->GetPoint(i));
      largest = std::max(largest, (to - from).norm());
      double nearest = 1e9;
      for (vtkIdType j = 0; j < pipeline.grid()->GetNumberOfPoints(); ++j)
        nearest = std::min(nearest, (Eigen::Vector3d(pipeline.grid()->GetPoint(j)) - to).norm());
      worst = std::max(worst, nearest);
    }
    RecordProperty(yaw == 0.0 ? "largest straight" : "largest turned", std::to_string(largest));
    EXPECT_GT(largest, 10.0) << "mm, the chin";
    RecordProperty(yaw == 0.0 ? "straight" : "turned", std::to_string(worst));
    EXPECT_LT(worst, 1.5)
        << "measured 0.8 mm, the mesh having rows on the curves; left behind, the chin's would lie 10 mm off";
  }
}

TEST(FacePipeline, SeveralTablesAddUpAndATableMayStandInTheStateItself) {
  const auto moves = [](const std::string& table) {
    FacePipeline pipeline;
    FaceState state;
    state.doublePrecision = true;
    state.deformation.table = table;
    pipeline.setState(state);
    EXPECT_EQ(pipeline.update(), "") << table;
    return Eigen::Vector3d(pipeline.grid()->GetPoint(42 * 41 + 17));
  };
  mien::DeformationTable blend =
      mien::DeformationTable::weighted({{*mien::namedTable("joy"), 0.5}, {*mien::namedTable("surprise"), 0.25}});
  EXPECT_LT((moves("joy:0.5,surprise:0.25") - moves(mien::writeTable(blend, "Half"))).norm(), 1e-9);
  EXPECT_GT((moves("joy:0.5,surprise:0.25") - moves("joy")).norm(), 0.1);
}

TEST(FacePipeline, ATableBendsATurnedHeadInItsOwnFrame) {
  const auto displacement = [](double yaw) {
    FacePipeline pipeline;
    FaceState state;
    state.doublePrecision = true;
    state.fapValues[49] = yaw;
    state.deformation.table = "surprise";
    pipeline.setState(state);
    EXPECT_EQ(pipeline.update(), "");
    vtkDataArray* moves = pipeline.grid()->GetPointData()->GetArray("Displacement");
    std::vector<double> lengths;
    for (vtkIdType i = 0; moves && i < moves->GetNumberOfTuples(); ++i) {
      const double* d = moves->GetTuple3(i);
      lengths.push_back(std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    }
    return lengths;
  };
  const std::vector<double> straight = displacement(0.0), turned = displacement(60000.0);
  ASSERT_EQ(straight.size(), turned.size());
  ASSERT_FALSE(straight.empty());
  EXPECT_GT(*std::max_element(straight.begin(), straight.end()), 10.0);
  for (std::size_t i = 0; i < straight.size(); ++i) ASSERT_NEAR(straight[i], turned[i], 1e-6) << i;
}

TEST(FacePipeline, AMissingFrameOrExpressionIsNamedAndCanBeMended) {
  FacePipeline pipeline;
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);
  pipeline.setState(animated(file, FaceState::FrameChoice::Index, 3));
  EXPECT_EQ(pipeline.update(), file + ": there is no frame with index 3; indices run from 0 to 2");
  pipeline.setState(animated(file, FaceState::FrameChoice::Number, 15));
  EXPECT_EQ(pipeline.update(), file + ": there is no frame with number 15; numbers run from 10 to 30");
  pipeline.setState(animated("/no/such.fap", FaceState::FrameChoice::Index, 0));
  EXPECT_EQ(pipeline.update().rfind("/no/such.fap: ", 0), 0u) << pipeline.update();
  FaceState state;
  state.expressions["envy"] = 1.0;
  pipeline.setState(state);
  EXPECT_EQ(pipeline.update().rfind("there is no expression 'envy'; there are ", 0), 0u) << pipeline.update();
  state = FaceState();
  state.visemes["zz"] = 1.0;
  pipeline.setState(state);
  EXPECT_EQ(pipeline.update().rfind("there is no viseme 'zz'; there are p b m, f v, ", 0), 0u) << pipeline.update();
  EXPECT_EQ(pipeline.updateNeutralCurves(), "");
  EXPECT_EQ(largestDisplacement(pipeline, FaceState()), 0.0);
}

/// FAP 1 blends its first shape by b / 63 and its second by the rest.
TEST(FacePipeline, TwoVisemesOfTheStateAreTheBlendOfFAPOne) {
  const TemporaryFolder folder;
  const std::string file = folder.file("viseme.fap");
  std::string mask = "1";
  for (int fap = 2; fap <= 68; ++fap) mask += " 0";
  writeTextFile(file, "2.1 viseme 25 1\n" + mask + "\n0 10 14 21 0\n");
  FaceState mixed;
  mixed.visemes = {{"A", 21.0 / 63.0}, {"U", 42.0 / 63.0}};
  FacePipeline selected, chosen;
  selected.setState(animated(file, FaceState::FrameChoice::Index, 0));
  ASSERT_EQ(selected.updateCurves(), "");
  chosen.setState(mixed);
  ASSERT_EQ(chosen.updateCurves(), "");
  vtkPolyData* a = vtkPolyData::SafeDownCast(selected.curves()->GetOutputDataObject(0));
  vtkPolyData* b = vtkPolyData::SafeDownCast(chosen.curves()->GetOutputDataObject(0));
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(a->GetPoint(i)[axis], b->GetPoint(i)[axis], 1e-9) << i;
  EXPECT_GT(largestDisplacement(chosen, mixed), 1.0);
}

TEST(FacePipeline, TheGridAloneMakesNoPolygons) {
  FacePipeline pipeline, whole;
  ASSERT_EQ(pipeline.update(), "");
  const auto polygons = pipeline.surface()->GetOutputDataObject(0)->GetMTime();
  FaceState state;
  state.expressions["joy"] = 1.0;
  pipeline.setState(state);
  whole.setState(state);
  ASSERT_EQ(pipeline.updateGrid(), "");
  ASSERT_EQ(whole.update(), "");
  EXPECT_EQ(pipeline.surface()->GetOutputDataObject(0)->GetMTime(), polygons);
  for (vtkIdType i = 0; i < pipeline.grid()->GetNumberOfPoints(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_EQ(pipeline.grid()->GetPoint(i)[axis], whole.grid()->GetPoint(i)[axis]) << i;
}

TEST(FacePipeline, ATimeBeyondTheAnimationIsRefusedWithItsLength) {
  FacePipeline pipeline;
  const TemporaryFolder folder;
  const std::string file = writeAnimation(folder);  // frames at 0, 0.5 and 1 s
  for (const double time : {0.0, 1.0, 1.4}) {
    pipeline.setState(animated(file, FaceState::FrameChoice::Time, time));
    EXPECT_EQ(pipeline.update(), "") << time;
  }
  pipeline.setState(animated(file, FaceState::FrameChoice::Time, 99));
  EXPECT_EQ(pipeline.update(), file + ": there is no frame at 99 s; the animation lasts from 0 to 1 s");
}

}  // namespace
