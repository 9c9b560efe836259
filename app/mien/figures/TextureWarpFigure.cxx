#include <algorithm>

#include "CatalogueFigures.h"
#include "DataFile.h"
#include "FaceTexture.h"
#include "FaceWarpLayout.h"
#include "Failure.h"
#include "FigureContext.h"
#include "ImageFile.h"
#include "OverlaidPanel.h"
#include "PicturePanel.h"
#include "PipelineErrors.h"
#include "PlatePainter.h"
#include "WarpMeshData.h"
#include "vtkFaceWarpMeshFilter.h"
#include "vtkImageData.h"
#include "vtkImageMeshWarpFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkWarpMeshReader.h"

namespace mien {

namespace {

constexpr double texturedShape = 1.2;
constexpr int textureHeight = 512;  // pixels; what is printed shows no more

/// The photograph, its mesh, and the mesh it is taken to.
struct Warp {
  vtkNew<vtkImageData> photograph;
  WarpMesh source, target;
};

WarpMesh readMesh(const std::string& file) {
  vtkNew<vtkWarpMeshReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  WarpMesh mesh;
  std::string fault = errors.first();
  if (fault.empty()) fault = readWarpMesh(reader->GetOutput(), mesh);
  if (!fault.empty()) throw FileFailure(fault);
  return mesh;
}

WarpMesh targetOn(vtkPolyData* curves, const WarpMesh& source) {
  FaceWarpLayout::Kind kind{};
  if (!FaceWarpLayout::kindOf(source, kind)) throw ValueFailure("the texture's mesh has no places on the face");
  vtkNew<vtkFaceWarpMeshFilter> filter;
  filter->SetInputDataObject(curves);
  filter->SetFine(kind == FaceWarpLayout::Kind::Fine);
  filter->SetTextureSize(2 * textureHeight, textureHeight);
  filter->Update();
  WarpMesh mesh;
  const std::string fault = readWarpMesh(filter->GetOutput(), mesh);
  if (!fault.empty()) throw FileFailure(fault);
  return mesh;
}

QImage warped(const Warp& warp, const WarpMesh& to) {
  vtkNew<vtkStructuredGrid> source, target;
  writeWarpMesh(warp.source, source);
  writeWarpMesh(to, target);
  vtkNew<vtkImageMeshWarpFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  filter->SetInputData(warp.photograph);
  filter->SetSourceMeshData(source);
  filter->SetTargetMeshData(target);
  filter->SetOutputSize(static_cast<int>(to.width), static_cast<int>(to.height));
  filter->Update();
  if (!errors.first().empty()) throw FileFailure(errors.first());
  return FigureContext::imageOf(filter->GetOutput());
}

/// After the first pass rows are done: x is the target's, y still the source's.
WarpMesh betweenPasses(const Warp& warp) {
  WarpMesh mesh = warp.target;
  mesh.height = warp.source.height;
  mesh.y = warp.source.y;
  return mesh;
}

PlaneDrawing meshDrawing(const WarpMesh& mesh) {
  PlaneDrawing drawing;
  const PlaneStroke stroke = {QColor("#0072b2"), 0.5};
  const auto place = [&](int row, int column) {
    return QPointF(mesh.x(row, column), mesh.height - mesh.y(row, column));
  };
  for (int row = 0; row < mesh.rows(); ++row) {
    QPolygonF line;
    for (int column = 0; column < mesh.columns(); ++column) line << place(row, column);
    drawing.lines.push_back({line, stroke});
  }
  for (int column = 0; column < mesh.columns(); ++column) {
    QPolygonF line;
    for (int row = 0; row < mesh.rows(); ++row) line << place(row, column);
    drawing.lines.push_back({line, stroke});
  }
  if (mesh.rows() > 10) return drawing;
  for (int i = 0; i < mesh.rows() * mesh.columns(); ++i)
    drawing.marks.push_back({place(i / mesh.columns(), i % mesh.columns()), 1.0, {QColor("#d55e00"), 0.5}});
  return drawing;
}

/// The middle half of a texture: v of the front of the head.
QImage frontalHalf(const QImage& texture) {
  return texture.copy(texture.width() / 4, 0, texture.width() / 2, texture.height());
}

PlaneDrawing frontalHalf(PlaneDrawing drawing, const QImage& texture) {
  const QPointF shift(-texture.width() / 4.0, 0.0);
  for (PlaneDrawing::Line& line : drawing.lines) line.points.translate(shift);
  for (PlaneDrawing::Mark& mark : drawing.marks) mark.at += shift;
  return drawing;
}

/// The texture and mesh of the state; the painted one with the paper's 7 x 7 points.
FaceState paperTexture(FigureContext& context) {
  FaceState state = context.textured(context.state());
  if (context.settings().textures.empty()) state.textureMesh = findDataFile("textures/painted_7x7.csv");
  if (state.textureMesh.empty()) state.textureMesh = meshBeside(state.texture);
  state.rows = 164;
  state.columns = 160;
  return state;
}

}  // namespace

FigureDrawing drawTextureWarp(FigureContext& context) {
  const FaceState state = paperTexture(context);
  Warp warp;
  const std::string fault = readImageFile(state.texture, warp.photograph);
  if (!fault.empty()) throw FileFailure(fault);
  const int* const size = warp.photograph->GetDimensions();
  warp.source = scaledMesh(readMesh(state.textureMesh), size[0], size[1]);
  warp.target = targetOn(context.neutralCurves(state), warp.source);
  const WarpMesh between = betweenPasses(warp);
  const QImage photograph = FigureContext::imageOf(warp.photograph), texture = warped(warp, warp.target);
  const QImage rows = warped(warp, between);
  Plate plate;
  plate.columns = context.isNarrow() ? 2 : 3;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  plate.panels = {picturePanel("Photograph", photograph),
                  overlaidPanel("Source mesh", photograph, meshDrawing(warp.source)),
                  overlaidPanel("Target mesh", frontalHalf(texture), frontalHalf(meshDrawing(warp.target), texture)),
                  overlaidPanel("First pass: rows", frontalHalf(rows), frontalHalf(meshDrawing(between), rows)),
                  picturePanel("Second pass: columns", frontalHalf(texture)),
                  context.facePanel("On the surface", state, SceneStyle(), width, texturedShape)};
  plate.caption =
      "Two-pass mesh warping: the mesh over the photograph is taken to the places of the same features in "
      "the surface's own coordinates v (across; its frontal half is shown) and u (down)." +
      std::string(context.settings().textures.empty() ? " The photograph is the texture painted by Mien." : "");
  return context.drawn(plate);
}

}  // namespace mien
