#include "CatalogueFigures.h"
#include "CurveDrawing.h"
#include "FigureContext.h"
#include "PanelRow.h"
#include "PlaneDrawingPainter.h"

namespace mien {

namespace {

const char* const expressions[] = {"anger", "joy", "sadness", "disgust", "fear", "surprise"};
constexpr size_t count = std::size(expressions);
constexpr int meshRows = 29, meshColumns = 40;  // as in the paper

FaceState withExpression(const FaceState& rest, const std::string& name) {
  FaceState state = rest;
  state.expressions[name] = 1.0;
  return state;
}

PlaneDrawing curveDrawing(FigureContext& context, const FaceState& state) {
  PlaneDrawing drawing;
  PlaneStroke thin;
  thin.width = 0.4;
  CurveDrawing(context.curves(state).curves).addLines(drawing, [&](int) { return thin; });
  return drawing;
}

/// One row of curves, seen in the same part of the plane.
PlatePanel curveRow(FigureContext& context) {
  std::vector<PlaneDrawing> drawings;
  QRectF shown;
  for (const char* const name : expressions) {
    drawings.push_back(curveDrawing(context, withExpression(context.state(), name)));
    shown = shown.united(drawings.back().bounds());
  }
  std::vector<PlatePanel> panels;
  for (size_t i = 0; i < count; ++i) panels.push_back(drawingPanel(expressions[i], drawings[i], shown));
  return panelRow("Boundary curves", panels, context.innerWidth());
}

PlatePanel faceRow(FigureContext& context, const std::string& heading, const FaceState& rest, SceneStyle::Mesh mesh) {
  SceneStyle style;
  style.mesh = mesh;
  if (mesh == SceneStyle::Mesh::Wireframe) style.samples = 6;  // fine lines in small pictures
  std::vector<FigureContext::NamedFace> faces;
  for (const char* const name : expressions) faces.push_back({"", withExpression(rest, name)});
  return panelRow(heading, context.facePanels(faces, style, context.innerWidth() / count, faceShape),
                  context.innerWidth());
}

}  // namespace

FigureDrawing drawExpressions(FigureContext& context) {
  FaceState mesh = context.state();
  mesh.rows = meshRows;
  mesh.columns = meshColumns;
  FaceState fine = context.textured(context.state());
  fine.rows = 164;
  fine.columns = 160;
  Plate plate;
  plate.columns = 1;
  plate.panels = {curveRow(context), faceRow(context, "Surface, 29 × 40 points", mesh, SceneStyle::Mesh::Wireframe),
                  faceRow(context, "Textured", fine, SceneStyle::Mesh::Shaded)};
  plate.caption = "The six expressions at full intensity, each from its FAPs; all panels of a row have one scale.";
  return context.drawn(plate);
}

}  // namespace mien
