#include "LandmarkFigure.h"

#include <memory>

#include "FaceTexture.h"
#include "Failure.h"
#include "FigureContext.h"
#include "OverlaidPanel.h"
#include "PlatePainter.h"
#include "vtkImageData.h"
#include "vtkNew.h"

namespace mien {

namespace {

constexpr double figureWidth = 130.0;                                     // mm
constexpr int largestSide = 1600;                                         // pixels of the photograph in the figure
constexpr double nameDistance = 0.9;                                      // mm
constexpr double radius = 1.5, landmarkNameSize = 6.5, numberSize = 5.0;  // pt

/// Where a name stands: outwards at the ends of brows, eyes and mouth, else above; below the lower lids, the nose and
/// the lower lip.
Qt::Alignment sideOf(const std::string& name) {
  if (name == "lower_lip_right") return Qt::AlignRight | Qt::AlignTop;
  if (name == "lower_lip_left") return Qt::AlignLeft | Qt::AlignTop;
  for (const char* right : {"4.6", "3.12", "5.4", "8.4"})
    if (name == right) return Qt::AlignRight | Qt::AlignVCenter;
  for (const char* left : {"4.5", "3.7", "5.3", "8.3"})
    if (name == left) return Qt::AlignLeft | Qt::AlignVCenter;
  for (const char* below : {"3.4", "3.3", "9.12", "8.8", "8.2", "8.7"})
    if (name == below) return Qt::AlignHCenter | Qt::AlignTop;
  return Qt::AlignHCenter | Qt::AlignBottom;
}

/// From a point to its name, so that the name leaves the point free.
QPointF wayTo(Qt::Alignment side, double distance) {
  return {side & Qt::AlignRight  ? -distance
          : side & Qt::AlignLeft ? distance
                                 : 0.0,
          side & Qt::AlignTop      ? -distance
          : side & Qt::AlignBottom ? distance
                                   : 0.0};
}

PlaneDrawing drawingOf(const ImageLandmarks& landmarks, double scale, const QSize& size) {
  PlaneDrawing drawing;
  const double textSize = landmarks.count("0") != 0 ? numberSize : landmarkNameSize;
  const double distance = nameDistance * size.width() / figureWidth;
  const QColor orange("#d55e00");
  for (const auto& [name, point] : landmarks) {
    const QPointF at(scale * point.x(), size.height() - scale * point.y());
    const Qt::Alignment side = sideOf(name);
    drawing.marks.push_back({at, radius, {Qt::white, 0.5, false, orange}});
    drawing.labels.push_back(
        {at + wayTo(side, distance), QString::fromStdString(name), textSize, int(side), {}, false, true});
  }
  return drawing;
}

}  // namespace

FigureDrawing drawLandmarks(vtkImageData* photograph, const ImageLandmarks& landmarks) {
  vtkNew<vtkImageData> reduced;
  const std::string fault = reduceImage(photograph, largestSide, {}, reduced);
  if (!fault.empty()) throw FileFailure(fault);
  const QImage picture = FigureContext::imageOf(reduced);
  Plate plate;
  plate.columns = 1;
  const double scale = static_cast<double>(picture.width()) / photograph->GetDimensions()[0];
  plate.panels = {overlaidPanel("", picture, drawingOf(landmarks, scale, picture.size()))};
  const auto painter = std::make_shared<PlatePainter>(plate, *FigureTheme::find("light"), figureWidth, false);
  return {painter->size(), [painter](QPainter& p) { painter->paint(p); }, {}, {}};
}

ImageLandmarks namedPoints(const WarpMesh& mesh) {
  ImageLandmarks points;
  for (std::size_t i = 0; i < mesh.names.size(); ++i) {
    const int row = static_cast<int>(i) / mesh.columns(), column = static_cast<int>(i) % mesh.columns();
    if (!mesh.names[i].empty()) points[mesh.names[i]] = {mesh.x(row, column), mesh.y(row, column)};
  }
  return points;
}

}  // namespace mien
