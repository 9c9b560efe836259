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
  plate.panels = {picturePanel("", studioPicture(context.state()))};
  plate.caption = "Mien Studio with the face of this state.";
  return context.drawn(plate);
}

}  // namespace mien
