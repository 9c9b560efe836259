#include "CatalogueFigures.h"
#include "CsvText.h"
#include "CurveModes.h"
#include "DetailFigure.h"
#include "FaceNote.h"
#include "Failure.h"
#include "FigureContext.h"
#include "PipelineErrors.h"
#include "TableRows.h"
#include "WatchedUpdate.h"
#include "vtkLevelOfDetailFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

constexpr int scanRows = 224, scanColumns = 160;  // of the surface that stands for a scan
constexpr double measuredSpacing = 6.0;           // mm, between the points at which distances are measured

std::vector<DetailPoint> pointsOf(vtkTable* table) {
  std::vector<DetailPoint> points;
  for (const json& row : tableRows(table)) {
    if (row["representation"] == "PDE face" || row["representation"] == "scan") continue;
    const auto number = [&](const char* key) { return row[key].is_number() ? row[key].get<double>() : std::nan(""); };
    points.push_back({row["representation"], number("bytes"), number("symmetric_rms_mm"), number("hausdorff_mm")});
  }
  return points;
}

}  // namespace

/// A scan is what `mien lod` takes; here the face's own fine surface stands for it, so that the figure needs no file.
FigureDrawing drawSizes(FigureContext& context) {
  FaceState state = context.state();
  state.rows = scanRows;
  state.columns = scanColumns;
  FacePipeline& pipeline = context.pipeline(state);
  vtkNew<vtkTriangleFilter> triangles;
  vtkNew<vtkReverseSense> outwards;
  triangles->SetInputConnection(pipeline.surface()->GetOutputPort());
  outwards->SetInputConnection(triangles->GetOutputPort());
  outwards->ReverseNormalsOff();
  outwards->Update();
  vtkNew<vtkLevelOfDetailFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputConnection(pipeline.curves()->GetOutputPort());
  filter->SetScanData(outwards->GetOutput());
  filter->SetParameters(state.surface);
  filter->SetSampleSpacing(measuredSpacing);
  updateWatched(filter, "comparison");
  if (!errors.first().empty()) throw FileFailure(errors.first());
  const int k = pipeline.pointsPerCurve();
  Figure figure = detailFigure(pointsOf(filter->GetOutput()), modeNumberCount(k, k / 2) * double(sizeof(float)),
                               "the face's own fine surface");
  figure.caption = "The reference is the face's own surface of " + std::to_string(scanRows) + " × " +
                   std::to_string(scanColumns) + " points, not a scan. " + figure.caption;
  figure.note = faceNote(state, {state.surface.scheme}) + "; measured every " + shortestText(measuredSpacing) + " mm";
  return context.drawn(figure);
}

}  // namespace mien
