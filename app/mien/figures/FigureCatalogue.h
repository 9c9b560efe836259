#pragma once

#include <string>
#include <vector>

#include "FaceState.h"
#include "FigureDrawing.h"

namespace mien {

class FigureContext;

/// What a figure heeds of the state that it is asked for; the rest is at rest in it.
struct FigureHeeds {
  bool face = true;     ///< curves, scheme, a and N
  bool motion = false;  ///< FAPs, expressions, visemes and the frame of a .fap file
  bool table = false;   ///< a deformation table
};

/// One figure that Mien can draw.
struct CatalogueFigure {
  std::string id;      ///< "pde-1"
  std::string source;  ///< the paper's figure: "Sheng et al. 2011, Figure 1"; empty for Mien's own
  std::string title;
  FigureDrawing (*draw)(FigureContext& context);
  FigureHeeds heeds;
  double leastWidth = 40.0;               ///< mm, below which names or tables would be cut or too small to be read
  std::vector<std::string> ignores = {};  ///< options of the face that it has values of its own for
  int textures = 0;                       ///< how many of the textures asked for it shows at most
  bool frames = false;                    ///< whether it shows frames of an animation
};

/// All of them, in the order of the papers. A new figure is one file and one line there.
const std::vector<CatalogueFigure>& figureCatalogue();

/// The state without what the figure does not heed.
FaceState heededState(const CatalogueFigure& figure, FaceState state);

/// The figure of that id; throws a ValueFailure that lists the known ones.
const CatalogueFigure& catalogueFigure(const std::string& id);

}  // namespace mien
