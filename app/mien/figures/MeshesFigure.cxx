#include "CatalogueFigures.h"
#include "FigureContext.h"
#include "PicturePanel.h"
#include "PlatePainter.h"

namespace mien {

namespace {

constexpr double meshShape = 1.1;  // height over width of a panel

}  // namespace

FigureDrawing drawMeshes(FigureContext& context) {
  Plate plate;
  plate.columns = context.isNarrow() ? 2 : 4;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  for (const auto& [rows, columns] : {std::pair{28, 20}, {50, 40}})
    for (const SceneStyle::Mesh mesh : {SceneStyle::Mesh::Wireframe, SceneStyle::Mesh::Shaded}) {
      FaceState state = context.state();
      state.rows = rows;
      state.columns = columns;
      SceneStyle style;
      style.mesh = mesh;
      const bool lines = mesh == SceneStyle::Mesh::Wireframe;
      const std::string size =
          std::to_string(rows) + " × " + std::to_string(columns) + (lines ? ", wireframe" : ", shaded");
      plate.panels.push_back(picturePanel(size, context.picture(state, style, width, meshShape)));
    }
  plate.caption = "Rows x columns of points on the same boundary curves.";
  return context.drawn(plate);
}

}  // namespace mien
