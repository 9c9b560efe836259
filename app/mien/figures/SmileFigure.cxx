#include "CatalogueFigures.h"
#include "FigureContext.h"
#include "PlatePainter.h"

namespace mien {

namespace {

constexpr double smileShape = 1.25;  // height over width of a panel

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
  for (const auto& [view, words] : {std::pair{"front", ", front"}, {"45", ", 45 degrees"}}) {
    SceneStyle style;
    style.view = parseView(view);
    const std::vector<FigureContext::NamedFace> faces = {{std::string("Neutral") + words, neutral},
                                                         {std::string("Deformed") + words, smile}};
    for (const PlatePanel& panel : context.facePanels(faces, style, width, smileShape)) plate.panels.push_back(panel);
  }
  const bool published = smile.deformation.table == "smile";
  plate.caption =
      (published ? "The published table of a smile (Table I)" : "The table " + smile.deformation.table) +
      std::string(" on this face, front and turned by 45 degrees, each pair at one scale.") +
      (published ? " Its sides are unequal: the crease at the right corner of the mouth is the table's." : "");
  return context.drawn(plate);
}

}  // namespace mien
