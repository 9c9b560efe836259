#include "CatalogueFigures.h"
#include "FigureContext.h"
#include "PlatePainter.h"

namespace mien {

namespace {

constexpr double shape = 1.25;  // height over width of a panel

}  // namespace

FigureDrawing drawSmile(FigureContext& context) {
  FaceState neutral = context.state();
  neutral.deformation.table.clear();
  neutral.rows = 164;
  neutral.columns = 160;
  FaceState smile = neutral;
  smile.deformation = context.state().deformation;
  if (smile.deformation.table.empty()) smile.deformation.table = "smile";
  Plate plate;
  plate.columns = context.isNarrow() ? 2 : 4;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  for (const char* const view : {"front", "45"})
    for (const FaceState& state : {neutral, smile}) {
      SceneStyle style;
      style.view = parseView(view);
      const std::string face = state.deformation.table.empty() ? "Neutral" : "Deformed";
      const std::string heading = face + (style.view.azimuth != 0.0 ? ", 45 degrees" : ", front");
      plate.panels.push_back(context.facePanel(heading, state, style, width, shape));
    }
  const bool published = smile.deformation.table == "smile";
  plate.caption = (published ? "The published table of a smile (Table I)" : "The table " + smile.deformation.table) +
                  std::string(" on this face, front and turned by 45 degrees.");
  return context.drawn(plate);
}

}  // namespace mien
