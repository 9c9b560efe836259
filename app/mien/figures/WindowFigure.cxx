#include <filesystem>

#include "CatalogueFigures.h"
#include "FigureContext.h"
#include "PicturePanel.h"
#include "StudioPicture.h"

namespace mien {

FigureDrawing drawWindow(FigureContext& context) {
  context.requireDisplay();
  Plate plate;
  plate.columns = 1;
  FaceState state = context.state();
  const bool atRest = state.expressions.empty() && state.visemes.empty() && state.fapValues.empty() &&
                      state.fapFile.empty() && state.deformation.table.empty();
  if (atRest) state.expressions["joy"] = 1.0;  // so that the window shows what it is for
  context.pipeline(state);                     // the window would show what is wrong; a figure has to be refused
  plate.panels = {picturePanel("", studioPicture(state))};
  plate.caption = std::string("Mien Studio with the face ") + (atRest ? "smiling (expression joy)." : "of this state.");
  return context.drawn(plate);
}

}  // namespace mien
