/// Filters that need whole curves: all of their output is in the first piece, and other pieces are empty without an
/// error. A parallel run would otherwise have it once per process, or complain of faces that lack curves.
#include <gtest/gtest.h>

#include "ErrorCounter.h"
#include "vtkBoundaryCurveMeanFilter.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkCurveEditFilter.h"
#include "vtkFAPAnimationFilter.h"
#include "vtkFAPReader.h"
#include "vtkFDTCurveFilter.h"
#include "vtkFDTFitFilter.h"
#include "vtkFDTReader.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPDEInfluenceFilter.h"
#include "vtkPDEModeFilter.h"
#include "vtkPDEParameterSweep.h"
#include "vtkPatchContinuityFilter.h"
#include "vtkPointSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceDistanceFilter.h"
#include "vtkTable.h"

namespace {

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkIdType sizeOf(vtkAlgorithm* filter, int port) {
  vtkDataObject* data = filter->GetOutputDataObject(port);
  if (auto* table = vtkTable::SafeDownCast(data)) return table->GetNumberOfRows();
  return vtkPointSet::SafeDownCast(data)->GetNumberOfPoints();
}

void updatePiece(vtkAlgorithm* filter, int port, int piece, int pieces) {
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(filter->GetNumberOfOutputPorts());
  requests->GetInformationObject(port)->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  requests->GetInformationObject(port)->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  requests->GetInformationObject(port)->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  filter->Update(port, requests);
}

void expectAllInFirstPiece(vtkAlgorithm* filter, int port, vtkIdType size) {
  const ErrorCounter errors(filter);
  updatePiece(filter, 0, 1, 3);
  for (const int piece : {1, 0, 2}) {
    updatePiece(filter, port, piece, 3);
    EXPECT_EQ(sizeOf(filter, port), piece == 0 ? size : 0) << filter->GetClassName() << ", piece " << piece;
  }
  updatePiece(filter, port, 0, 1);
  EXPECT_EQ(sizeOf(filter, port), size) << filter->GetClassName();
  EXPECT_EQ(errors.count(), 0) << errors.first();
}

constexpr vtkIdType curvePoints = 29 * 40;

struct LaterPiece : ::testing::Test {
  LaterPiece() {
    Frames->SetFileName(MIEN_DATA_DIR "/animation/demo.fap");
    Table->SetFileName("joy");
    Smiling->SetInputConnection(Curves->GetOutputPort());
    Smiling->SetExpression("joy", 1.0);
    Surface->SetInputConnection(Curves->GetOutputPort());
    SmilingSurface->SetInputConnection(Smiling->GetOutputPort());
  }
  vtkNew<vtkBoundaryCurveReader> Curves;
  vtkNew<vtkFAPReader> Frames;
  vtkNew<vtkFDTReader> Table;
  vtkNew<vtkFAPAnimationFilter> Smiling;
  vtkNew<vtkPDEFaceFilter> Surface, SmilingSurface;
};

}  // namespace

TEST_F(LaterPiece, OfCurvesIsEmpty) {
  expectAllInFirstPiece(Curves, 0, curvePoints);
  vtkNew<vtkFAPAnimationFilter> animated;
  animated->SetInputConnection(Curves->GetOutputPort());
  animated->SetFAPConnection(Frames->GetOutputPort());
  expectAllInFirstPiece(animated, 0, curvePoints);
  vtkNew<vtkFDTCurveFilter> deformed;
  deformed->SetInputConnection(Smiling->GetOutputPort());
  deformed->SetTableConnection(Table->GetOutputPort());
  expectAllInFirstPiece(deformed, 0, curvePoints);
  vtkNew<vtkCurveEditFilter> edited;
  edited->SetInputConnection(Curves->GetOutputPort());
  edited->AddEdit("C10", 3.0, 0.0, 0.0, 1.0, 30.0, 2, false);
  expectAllInFirstPiece(edited, 0, curvePoints);
  vtkNew<vtkBoundaryCurveMeanFilter> mean;
  mean->AddInputConnection(Curves->GetOutputPort());
  mean->AddInputConnection(Smiling->GetOutputPort());
  expectAllInFirstPiece(mean, 0, curvePoints);
}

TEST_F(LaterPiece, OfMeasuresIsEmpty) {
  vtkNew<vtkPDEParameterSweep> sweep;
  sweep->SetInputConnection(Curves->GetOutputPort());
  sweep->SetSmoothingRange("1,2");
  sweep->SetResolution(40, 40);
  expectAllInFirstPiece(sweep, 0, 2);
  vtkNew<vtkSurfaceDistanceFilter> distance;
  distance->SetInputConnection(Surface->GetOutputPort());
  distance->SetReferenceConnection(SmilingSurface->GetOutputPort());
  expectAllInFirstPiece(distance, 0, 56 * 41);
  expectAllInFirstPiece(distance, 1, 56 * 41);
  expectAllInFirstPiece(distance, 2, 2);
  vtkNew<vtkFDTFitFilter> fit;
  fit->SetInputConnection(Surface->GetOutputPort());
  fit->SetExpressionConnection(SmilingSurface->GetOutputPort());
  fit->SetAllowEmptyRegions(true);
  expectAllInFirstPiece(fit, 0, 16);
}

TEST_F(LaterPiece, OfTheTableBesideASurfaceIsEmpty) {
  vtkNew<vtkPDEModeFilter> modes;
  modes->SetInputConnection(Curves->GetOutputPort());
  expectAllInFirstPiece(modes, 1, 7);
  vtkNew<vtkPDEInfluenceFilter> influence;
  influence->SetInputConnection(Curves->GetOutputPort());
  expectAllInFirstPiece(influence, 1, 56);
  vtkNew<vtkPatchContinuityFilter> continuity;
  continuity->SetInputConnection(Curves->GetOutputPort());
  expectAllInFirstPiece(continuity, 1, 9);
}
