/// The mean tables and Table I on head meshes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "FDTData.h"
#include "LandmarkTable.h"
#include "NamedTables.h"
#include "PipelineErrors.h"
#include "ReferenceData.h"
#include "TextFile.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFDTDeformationFilter.h"
#include "vtkFDTFitFilter.h"
#include "vtkFacialRegionFilter.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPupilNormalizeFilter.h"
#include "vtkTable.h"

namespace {

const char* const expressions[] = {"anger", "disgust", "fear", "joy", "sadness", "surprise"};

/// A head of the reference data deformed by a table.
struct Head {
  vtkNew<vtkPLYReader> reader;
  vtkNew<vtkFDTDeformationFilter> filter;
  mien::LandmarkTable landmarks;
  double unit = 0.0;

  explicit Head(const std::string& name) {
    reader->SetFileName(referencePath("heads/" + name + ".ply").c_str());
    filter->SetInputConnection(reader->GetOutputPort());
    filter->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
    EXPECT_EQ(mien::parseLandmarks(readTextFile(referencePath("heads/landmarks68.csv")), landmarks), "");
    vtkNew<vtkPupilNormalizeFilter> pupils;
    pupils->SetInputConnection(reader->GetOutputPort());
    pupils->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
    pupils->Update();
    vtkDataArray* places = pupils->GetOutput()->GetFieldData()->GetArray("OriginalPupils");
    unit = 0.5 * std::hypot(places->GetComponent(0, 0) - places->GetComponent(1, 0),
                            places->GetComponent(0, 1) - places->GetComponent(1, 1));
  }

  void deform(const mien::DeformationTable& table, bool smooth = true) {
    vtkNew<vtkTable> data;
    mien::writeFDT(table, data);
    filter->SetTableData(data);
    filter->SetSmooth(smooth);
    filter->Update();
  }
  Eigen::Vector3d before(vtkIdType i) const { return Eigen::Vector3d(reader->GetOutput()->GetPoint(i)); }
  Eigen::Vector3d after(vtkIdType i) const { return Eigen::Vector3d(filter->GetOutput()->GetPoint(i)); }
  Eigen::Vector3d landmarkMove(int landmark) const {
    return (after(landmarks.vertices[landmark]) - before(landmarks.vertices[landmark])) / unit;
  }

  /// Calls function(ids) for each triangle in front of z = 50 mm, quads taken as two.
  template <class Function>
  void forFrontalTriangles(const Function& function) const {
    vtkNew<vtkIdList> ids;
    vtkCellArray* cells = reader->GetOutput()->GetPolys();
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
      cells->GetCellAtId(cell, ids);
      for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k) {
        const std::array<vtkIdType, 3> t = {ids->GetId(0), ids->GetId(k - 1), ids->GetId(k)};
        if ((before(t[0]).z() + before(t[1]).z() + before(t[2]).z()) / 3.0 > 50.0) function(t);
      }
    }
  }
};

}  // namespace

TEST(FDTHead, NoTriangleFlipsAndNothingRunsAway) {
  MIEN_REQUIRE_REFERENCE("heads");
  Head head("generic_neutral");
  for (const char* expression : expressions) {
    const mien::DeformationTable& table = *mien::namedTable(expression);
    head.deform(table);
    int flips = 0, triangles = 0;
    head.forFrontalTriangles([&](const std::array<vtkIdType, 3>& t) {
      const auto normal = [&](auto point) {
        return (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).eval();
      };
      const Eigen::Vector3d a = normal([&](vtkIdType i) { return head.before(i); });
      const Eigen::Vector3d b = normal([&](vtkIdType i) { return head.after(i); });
      flips += a.dot(b) <= 0.0;
      ++triangles;
    });
    EXPECT_GT(triangles, 5000);
    EXPECT_EQ(flips, 0) << expression;
    for (vtkIdType i = 0; i < head.reader->GetOutput()->GetNumberOfPoints(); ++i)
      ASSERT_LE((head.after(i) - head.before(i)).norm(), 1.5 * table.largestDisplacement * head.unit + 1e-5)
          << expression;
  }
}

TEST(FDTHead, MeanSurpriseOpensTheMouth) {
  MIEN_REQUIRE_REFERENCE("heads");
  Head head("generic_neutral");
  const auto gap = [&](bool moved) {
    const long upper = head.landmarks.vertices[62], lower = head.landmarks.vertices[66];
    return moved ? (head.after(upper) - head.after(lower)).norm() : (head.before(upper) - head.before(lower)).norm();
  };
  for (const bool smooth : {true, false}) {
    head.deform(*mien::namedTable("surprise"), smooth);
    EXPECT_GE(gap(true) - gap(false), 6.0) << (smooth ? "smooth" : "hard");
  }
}

TEST(FDTHead, TableOneSmilesOnEveryHead) {
  MIEN_REQUIRE_REFERENCE("heads");
  for (int subject = 0; subject <= 12; ++subject) {
    const std::string name =
        subject ? "subject" + std::string(subject < 10 ? "0" : "") + std::to_string(subject) + "_neutral"
                : "generic_neutral";
    Head head(name);
    head.deform(*mien::namedTable("smile"));
    const Eigen::Vector3d right = head.landmarkMove(48), left = head.landmarkMove(54);
    for (const Eigen::Vector3d& corner : {right, left}) {
      EXPECT_GE(corner.y(), 0.1) << name;
      EXPECT_LE(corner.y(), 0.25) << name;
    }
    EXPECT_GT(left.x() - right.x(), 0.1) << name << ": the mouth widens";
    EXPECT_LT(std::abs(left.x() + right.x()), 0.06) << name << ": as even as its numbers";
    EXPECT_LT(std::abs(left.y() - right.y()), 0.08) << name;
    double lift[2] = {0.0, 0.0};
    int count[2] = {0, 0};
    for (vtkIdType i = 0; i < head.filter->GetOutput()->GetNumberOfPoints(); ++i) {
      const Eigen::Vector3d p = head.before(i) / head.unit;
      // Cheeks: between nose and ear, between lower lid and mouth, in front.
      const Eigen::Vector3d nose = head.before(head.landmarks.vertices[30]) / head.unit;
      const double x = p.x() - nose.x(), y = p.y() - nose.y();
      if (std::abs(x) < 0.9 || std::abs(x) > 1.3 || std::abs(y + 0.3) > 0.25 || p.z() < 1.8) continue;
      lift[x > 0] += (head.after(i) - head.before(i)).y() / head.unit;
      ++count[x > 0];
    }
    for (const int side : {0, 1}) EXPECT_GT(lift[side] / count[side], 0.02) << name << " cheek " << side;
  }
}

TEST(FDTHead, SidesAndWeightsChangeEvenlyAlongEdges) {
  MIEN_REQUIRE_REFERENCE("heads");
  Head head("generic_neutral");
  vtkNew<vtkFacialRegionFilter> filter;
  filter->SetInputConnection(head.reader->GetOutputPort());
  filter->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  vtkDataArray *lips = data->GetArray("LipSide"), *lids = data->GetArray("LidSide");
  ASSERT_TRUE(lips && lids);
  EXPECT_EQ(lips->GetComponent(head.landmarks.vertices[62], 0), 1.0);
  EXPECT_EQ(lips->GetComponent(head.landmarks.vertices[66], 0), -1.0);
  EXPECT_NEAR(lips->GetComponent(head.landmarks.vertices[48], 0), 0.0, 0.25) << "the corner of the mouth";
  for (const int lid : {37, 38, 43, 44}) EXPECT_EQ(lids->GetComponent(head.landmarks.vertices[lid], 0), 1.0) << lid;
  for (const int lid : {40, 41, 46, 47}) EXPECT_EQ(lids->GetComponent(head.landmarks.vertices[lid], 0), -1.0) << lid;
  // An edge of length e changes a side by at most 2 e / half width and 1.5 e / reach: no border but the slits.
  head.forFrontalTriangles([&](const std::array<vtkIdType, 3>& t) {
    for (int k = 0; k < 3; ++k) {
      const double edge = (head.before(t[k]) - head.before(t[(k + 1) % 3])).norm();
      ASSERT_LE(std::abs(lips->GetComponent(t[k], 0) - lips->GetComponent(t[(k + 1) % 3], 0)),
                edge * (2.0 / 22.0 + 1.5 / 31.0) + 1e-6);
    }
  });
}

TEST(FDTHead, AFitOfTwoHeadsGivesTheExpressionBack) {
  MIEN_REQUIRE_REFERENCE("heads");
  vtkNew<vtkPLYReader> neutral, joy;
  neutral->SetFileName(referencePath("heads/subject01_neutral.ply").c_str());
  joy->SetFileName(referencePath("heads/subject01_joy.ply").c_str());
  vtkNew<vtkFDTFitFilter> fit;
  fit->SetInputConnection(neutral->GetOutputPort());
  fit->SetExpressionConnection(joy->GetOutputPort());
  fit->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
  fit->Update();
  mien::DeformationTable table;
  ASSERT_EQ(mien::readFDT(fit->GetOutput(), table), "");
  EXPECT_LT(fit->GetRMS(), 0.03);
  Head head("subject01_neutral");
  head.deform(table);
  for (const int corner : {48, 54}) EXPECT_GT(head.landmarkMove(corner).y(), 0.15) << corner;
}
