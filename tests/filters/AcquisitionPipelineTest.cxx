#include <gtest/gtest.h>

#include "BoundaryCurveData.h"
#include "ErrorCounter.h"
#include "FaceAcquisition.h"
#include "LandmarkTable.h"
#include "MeshPolyData.h"
#include "ScanAcquisition.h"
#include "SyntheticHead.h"
#include "TemporaryFolder.h"
#include "TextFile.h"
#include "vtkBoundaryCurveAcquisitionFilter.h"
#include "vtkBoundaryCurveMeanFilter.h"
#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace {

/// The filter on a smooth head with its landmarks.
struct Measured {
  TemporaryFolder folder;
  vtkNew<vtkPolyData> scan;
  vtkNew<vtkBoundaryCurveAcquisitionFilter> filter;

  Measured() {
    const SyntheticHead head = ellipticHead();
    fillPolyData(head.mesh(), scan);
    writeTextFile(folder.file("landmarks.csv"), mien::landmarkText(head.landmarks()));
    filter->SetLandmarkFileName(folder.file("landmarks.csv").c_str());
    filter->SetInputData(scan);
  }
};

/// Aborts a filter once its progress lies within a range.
struct Abort {
  double from, to;
  int calls = 0;
  vtkNew<vtkCallbackCommand> command;

  Abort(vtkAlgorithm* filter, double first, double last) : from(first), to(last) {
    command->SetClientData(this);
    command->SetCallback([](vtkObject* caller, unsigned long, void* self, void*) {
      auto* algorithm = static_cast<vtkAlgorithm*>(caller);
      auto* abort = static_cast<Abort*>(self);
      if (algorithm->GetProgress() <= abort->from || algorithm->GetProgress() >= abort->to) return;
      ++abort->calls;
      algorithm->SetAbortExecute(1);
    });
    filter->AddObserver(vtkCommand::ProgressEvent, command);
  }
};

int piecesOf(vtkAlgorithm* filter, int connection) {
  return filter->GetInputInformation(0, connection)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES());
}

}  // namespace

TEST(AcquisitionPipeline, APieceOfTheCurvesNeedsTheWholeScan) {
  const Measured measured;
  measured.filter->UpdatePiece(0, 3, 0);
  EXPECT_EQ(piecesOf(measured.filter, 0), 1);
  EXPECT_EQ(measured.filter->GetOutput()->GetNumberOfPoints(), 29 * 40);
}

TEST(AcquisitionPipeline, APieceOfTheMeanNeedsWholeFaces) {
  const Measured measured;
  measured.filter->Update();
  vtkNew<vtkPolyData> other;
  other->ShallowCopy(measured.filter->GetOutput());
  vtkNew<vtkBoundaryCurveMeanFilter> mean;
  mean->AddInputConnection(measured.filter->GetOutputPort());
  mean->AddInputDataObject(other);
  mean->UpdatePiece(0, 4, 0);
  EXPECT_EQ(piecesOf(mean, 0), 1);
  EXPECT_EQ(piecesOf(mean, 1), 1);
  EXPECT_EQ(mean->GetOutput()->GetNumberOfPoints(), 29 * 40);
}

TEST(AcquisitionPipeline, AnAbortIsNoErrorAndLeavesEmptyOutputs) {
  const Measured measured;
  measured.filter->Update();
  ASSERT_GT(measured.filter->GetOutput(1)->GetNumberOfPoints(), 0);
  const Abort abort(measured.filter, 0.5, 1.0);
  ErrorCounter errors(measured.filter);
  measured.filter->Modified();
  measured.filter->Update();
  EXPECT_GT(abort.calls, 0);
  EXPECT_EQ(errors.first(), "") << "no failed request either";
  EXPECT_EQ(measured.filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(measured.filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

TEST(AcquisitionPipeline, DecimationTellsItsProgressAndStops) {
  const Measured measured;
  measured.filter->SetTriangles(12000);
  measured.filter->Update();
  EXPECT_LE(measured.filter->GetAcquired().report.triangles, 12000);
  const Abort abort(measured.filter, 0.01, 0.25);
  measured.filter->Modified();
  measured.filter->Update();
  EXPECT_EQ(abort.calls, 1) << "the first wish to stop is heard";
  EXPECT_EQ(measured.filter->GetOutput()->GetNumberOfPoints(), 0);
}
