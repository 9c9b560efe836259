#include <gtest/gtest.h>

#include <cmath>

#include "Acquire.h"
#include "FaceFiles.h"
#include "FaceLayout.h"
#include "ReferenceData.h"
#include "TemporaryFolder.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"
#include "vtkSurfaceDistanceFilter.h"

namespace {

double frontalDistance(const std::string& scheme, const std::string& head) {
  vtkNew<vtkBoundaryCurveReader> curves;
  vtkNew<vtkPDEFaceFilter> face;
  face->SetInputConnection(curves->GetOutputPort());
  face->SetScheme(scheme);
  face->SetSmoothing(1.0);
  face->SetNumberOfModes(5);
  face->SetResolution(224, 160);
  vtkNew<vtkScanReader> scan;
  scan->SetFileName(head.c_str());
  vtkNew<vtkSurfaceDistanceFilter> distance;
  distance->SetInputConnection(face->GetOutputPort());
  distance->SetReferenceConnection(scan->GetOutputPort());
  distance->FrontalOnlyOn();
  distance->LargestComponentOnlyOn();  // the skin without the eyeballs
  distance->Update();
  return distance->GetRMSDistance(0);
}

}  // namespace

TEST(GenericFace, HasNoFault) {
  EXPECT_EQ(describeFault(genericFace()), "");
}

TEST(GenericFace, IsItsOwnMirrorImageToTheLastBit) {
  const mien::FaceCurves face = genericFace();
  const int k = face.curves.pointsPerCurve;
  for (int c = 0; c < face.curves.count; ++c) {
    for (int j = 0; j < k; ++j) {
      const Eigen::Vector3d p = face.curves.curve(c).row(j), q = face.curves.curve(c).row((k - j) % k);
      EXPECT_EQ(p, Eigen::Vector3d(-q.x(), q.y(), q.z()));
    }
    EXPECT_EQ(face.curves.curve(c)(0, 0), 0.0);
    EXPECT_EQ(face.curves.curve(c)(k / 2, 0), 0.0);
  }
  EXPECT_EQ(face.leftPupil.x(), -face.rightPupil.x());
}

TEST(GenericFace, ClosesItsMouth) {
  const mien::FaceCurves face = genericFace();
  EXPECT_EQ(face.curves.curve(mien::FaceLayout::upperLip), face.curves.curve(mien::FaceLayout::lowerLip));
}

TEST(GenericFace, HoldsTheFeaturePointsOfThe22FAPs) {
  const mien::FaceCurves face = genericFace();
  EXPECT_TRUE(face.hasPupils);
  for (const char* id : {"3.1", "3.2", "3.3", "3.4", "4.1", "4.2", "4.3", "4.4", "4.5", "4.6",  "5.1", "5.2",
                         "5.3", "5.4", "8.1", "8.2", "8.3", "8.4", "9.1", "9.2", "9.3", "9.15", "2.2", "2.3"})
    EXPECT_NE(face.feature(id), nullptr) << id;
}

TEST(GenericFace, HasTheProportionsOfAnAdult) {
  const mien::FaceCurves face = genericFace();
  const auto at = [&](const char* id) { return face.curves.at(face.feature(id)->curve, face.feature(id)->v); };
  EXPECT_NEAR(face.leftPupil.x() - face.rightPupil.x(), 62.0, 6.0);  // pupil distance of adults, 54 to 74 mm
  EXPECT_NEAR(at("8.3").x() - at("8.4").x(), 50.0, 6.0);             // mouth width
  EXPECT_GT(at("9.3").z(), at("9.15").z() + 5.0);                    // the nose tip stands out
  EXPECT_GT(at("3.1").y() - at("3.3").y(), 5.0);                     // eyes are open
}

TEST(GenericFace, EarsDoNotShow) {
  const mien::FaceCurves face = genericFace();
  const mien::ClosedCurves& curves = face.curves;
  for (int c = 0; c < curves.count; ++c)
    for (int j = 4; j <= 10; ++j) {
      const auto radius = [&](int i) { return std::hypot(curves.curve(c)(i, 0), curves.curve(c)(i, 2) - 25.0); };
      EXPECT_LT(radius(j) - 0.5 * (radius(j - 1) + radius(j + 1)), 3.0) << mien::FaceLayout::curveName(c) << " " << j;
    }
}

TEST(GenericFace, LiesOnTheMeanHead) {
  MIEN_REQUIRE_REFERENCE("heads/mean_neutral.ply");
  EXPECT_LT(frontalDistance("four-curve", referencePath("heads/mean_neutral.ply")), 0.55);
}

TEST(GenericFace, IsWhatTheDocumentedCommandMeasures) {
  MIEN_REQUIRE_REFERENCE("heads/generic_neutral.ply");
  mien::AcquireOptions options;
  options.scans.push_back(referencePath("heads/generic_neutral.ply"));
  for (int i = 1; i <= 12; ++i)
    options.scans.push_back(
        referencePath("heads/subject" + std::string(i < 10 ? "0" : "") + std::to_string(i) + "_neutral.ply"));
  options.landmarkFile = referencePath("heads/landmarks68.csv");
  const TemporaryFolder folder;
  options.outputFile = folder.file("generic.vtp");
  options.mean = true;
  options.scan.nostrils = true;
  ASSERT_EQ(mien::acquire(options), "");
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->SetFileName(options.outputFile.c_str());
  reader->Update();
  mien::FaceCurves again;
  ASSERT_EQ(mien::readFaceCurves(reader->GetOutput(), again), "");
  const mien::FaceCurves face = genericFace();
  EXPECT_LT((again.curves.points - face.curves.points).cwiseAbs().maxCoeff(), 1e-9);
  ASSERT_EQ(again.features.size(), face.features.size());
  for (std::size_t i = 0; i < face.features.size(); ++i) EXPECT_NEAR(again.features[i].v, face.features[i].v, 1e-9);
}
