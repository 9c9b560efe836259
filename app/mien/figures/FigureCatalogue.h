#pragma once

#include <string>
#include <vector>

#include "FigureDrawing.h"

namespace mien {

class FigureContext;

/// One figure that Mien can draw.
struct CatalogueFigure {
  std::string id;      ///< "pde-1"
  std::string source;  ///< the paper's figure: "Sheng et al. 2011, Figure 1"; empty for Mien's own
  std::string title;
  FigureDrawing (*draw)(FigureContext& context);
  int textures = 0;     ///< how many of the textures asked for it shows at most
  bool frames = false;  ///< whether it shows frames of an animation
};

/// All of them, in the order of the papers. A new figure is one file and one line there.
const std::vector<CatalogueFigure>& figureCatalogue();

/// The figure of that id; throws a ValueFailure that lists the known ones.
const CatalogueFigure& catalogueFigure(const std::string& id);

}  // namespace mien
