/// Eyes of head meshes, and heads that do not look forward.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "DeformedHead.h"
#include "NamedTables.h"
#include "PipelineErrors.h"
#include "vtkCallbackCommand.h"
#include "vtkFacialRegionFilter.h"

TEST(FDTPosture, BothShellsOfEachEyeStayByLandmarksAndByPupils) {
  MIEN_REQUIRE_REFERENCE("heads");
  for (const char* name : {"generic_neutral", "subject05_neutral"})
    for (const bool byPupils : {false, true}) {
      Head head(name);
      if (byPupils) {
        head.filter->SetLandmarkFileName("");
        head.filter->SetLeftPupil(31, 36, 90);
        head.filter->SetRightPupil(-31, 36, 90);
      }
      head.deform(*mien::namedTable("surprise"));
      // The skin comes first in the file, the shells of the eyes after it: 2 x (800 + 770).
      const vtkIdType skin = 11248;
      ASSERT_EQ(head.reader->GetOutput()->GetNumberOfPoints(), skin + 3140);
      for (vtkIdType i = skin; i < skin + 3140; ++i)
        ASSERT_EQ((head.after(i) - head.before(i)).norm(), 0.0) << name << " " << i;
      EXPECT_GT(head.largestMove(), 10.0);
    }
}

namespace {

/// What the joy of a head is after its points were changed by `change`: the largest difference from the change of the
/// head's own joy, mm; or the fault.
std::pair<double, std::string> joyOfChanged(const Eigen::Matrix3d& change, bool byPupils = false) {
  Head head("subject01_neutral");
  head.deform(*mien::namedTable("joy"));
  vtkNew<vtkPolyData> changed;
  changed->DeepCopy(head.reader->GetOutput());
  for (vtkIdType i = 0; i < changed->GetNumberOfPoints(); ++i)
    changed->GetPoints()->SetPoint(i, (change * head.before(i)).eval().data());
  vtkNew<vtkFDTDeformationFilter> filter;
  mien::PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(changed);
  vtkNew<vtkTable> table;
  mien::writeFDT(*mien::namedTable("joy"), table);
  filter->SetTableData(table);
  if (byPupils) {
    filter->SetLeftPupil((change * Eigen::Vector3d(31, 36, 85)).eval().data());
    filter->SetRightPupil((change * Eigen::Vector3d(-31, 36, 85)).eval().data());
  } else {
    filter->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
  }
  filter->Update();
  double largest = 0.0;
  for (vtkIdType i = 0; errors.first().empty() && i < changed->GetNumberOfPoints(); ++i)
    largest = std::max(largest, (Eigen::Vector3d(filter->GetOutput()->GetPoint(i)) - change * head.after(i)).norm());
  return {largest, errors.first()};
}

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180.0, axis).toRotationMatrix();
}

}  // namespace

TEST(FDTPosture, AHeadTurnedAsideIsDeformedAsIfItLookedForward) {
  MIEN_REQUIRE_REFERENCE("heads");
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  // Joy moves this head by up to 13 mm. Yaw is told to half a degree, pitch leans with the form of each face: what is
  // left here is 4 degrees of pitch that are this subject's own.
  for (const auto& [change, allowed] :
       {std::pair(turn(20, y), 0.5), std::pair(turn(-40, y), 0.5), std::pair(turn(25, x), 2.5),
        std::pair((turn(10, z) * turn(30, y) * turn(-25, x)).eval(), 2.5)}) {
    const auto [largest, fault] = joyOfChanged(change);
    EXPECT_EQ(fault, "");
    EXPECT_LT(largest, allowed);
  }
}

TEST(FDTPosture, MirroredBackwardAndUpsideDownHeadsAreRefused) {
  MIEN_REQUIRE_REFERENCE("heads");
  const Eigen::Matrix3d mirrored = Eigen::Vector3d(-1, 1, 1).asDiagonal(),
                        inside = Eigen::Vector3d(1, 1, -1).asDiagonal();
  const Eigen::Matrix3d backwards = turn(180, Eigen::Vector3d::UnitY());
  EXPECT_NE(joyOfChanged(mirrored).second.find("mirrored by its landmarks"), std::string::npos);
  EXPECT_NE(joyOfChanged(inside).second.find("mirrored by its landmarks"), std::string::npos);
  EXPECT_NE(joyOfChanged(backwards).second.find("looks backwards by its landmarks"), std::string::npos);
  EXPECT_EQ(joyOfChanged(Eigen::Matrix3d::Identity(), true).second, "");
  EXPECT_EQ(joyOfChanged(turn(90, Eigen::Vector3d::UnitZ()), true).second, "") << "lying on its side";
  EXPECT_NE(joyOfChanged(mirrored, true).second.find("the nose lies above the eyes"), std::string::npos);
  EXPECT_NE(joyOfChanged(backwards, true).second, "");
  EXPECT_NE(joyOfChanged(inside, true).second.find("looks backwards"), std::string::npos);
}

TEST(FDTPosture, AFaceThatLooksAsideIsToldOf) {
  MIEN_REQUIRE_REFERENCE("heads");
  Head head("subject01_neutral");
  const auto told = [&](double yaw, double pitch) {
    vtkNew<vtkPolyData> turned;
    turned->DeepCopy(head.reader->GetOutput());
    const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(yaw * M_PI / 180.0, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(pitch * M_PI / 180.0, Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix();
    for (vtkIdType i = 0; i < turned->GetNumberOfPoints(); ++i)
      turned->GetPoints()->SetPoint(i, (rotation * head.before(i)).eval().data());
    vtkNew<vtkFacialRegionFilter> filter;
    mien::PipelineErrors errors;
    std::string warning;
    errors.observe(filter);
    vtkNew<vtkCallbackCommand> listen;
    listen->SetClientData(&warning);
    listen->SetCallback([](vtkObject*, unsigned long, void* text, void* data) {
      *static_cast<std::string*>(text) = static_cast<const char*>(data);
    });
    filter->AddObserver(vtkCommand::WarningEvent, listen);
    filter->SetInputData(turned);
    filter->SetLandmarkFileName(referencePath("heads/landmarks68.csv"));
    filter->Update();
    return std::pair(warning, errors.first());
  };
  EXPECT_EQ(told(0.0, 0.0), std::pair(std::string(), std::string()));
  EXPECT_EQ(told(6.0, 0.0).first, "");
  EXPECT_NE(told(25.0, 0.0).first.find("the face looks 25 degrees to the side"), std::string::npos);
  EXPECT_NE(told(0.0, 20.0).first.find(" down by its landmarks"), std::string::npos);
  EXPECT_NE(told(0.0, -90.0).second.find(" up by its landmarks"), std::string::npos) << "lying on its back";
}
