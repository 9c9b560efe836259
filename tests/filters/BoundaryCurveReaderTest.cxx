#include "BoundaryCurveData.h"
#include "FaceLayout.h"
#include "vtkBoundaryCurveReader.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

TEST(BoundaryCurveReader, GivesTheGenericFaceWithoutAFile) {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  mien::FaceCurves face;
  EXPECT_EQ(mien::readFaceCurves(reader->GetOutput(), face), "");
  EXPECT_EQ(face.curves.count, mien::FaceLayout::curveCount);
  EXPECT_EQ(face.curves.pointsPerCurve, 40);
}
