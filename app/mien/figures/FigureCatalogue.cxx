#include "FigureCatalogue.h"

#include <algorithm>

#include "CatalogueFigures.h"
#include "FaceMotion.h"
#include "Failure.h"

namespace mien {

namespace {

const std::string sheng = "Sheng et al. 2011, ", obaid = "Obaid et al. 2009, ";

constexpr double usualWidth = 40.0;  // mm
constexpr int mostTextures = 8;      // rows of one figure

constexpr FigureHeeds noFace{false}, atRest{}, animated{true, true}, deformed{true, false, true},
    moved{true, true, true};

const std::vector<CatalogueFigure> figures = {
    {"pde-1", sheng + "Figure 1", "Boundary curves of the face", drawBoundaryCurves, atRest},
    {"pde-2", sheng + "Figure 2", "One face at two resolutions", drawMeshes, moved, usualWidth, {"--resolution"}},
    {"pde-3", sheng + "Figure 3", "Texture warp", drawTextureWarp, moved, usualWidth, {}, 1},
    {"pde-4", sheng + "Figure 4", "Moving one curve", drawActiveArea, moved},
    {"pde-5", sheng + "Figure 5", "The left eyebrow", drawEyebrow, atRest},
    {"pde-6", sheng + "Figure 6", "The mouth", drawMouth, atRest},
    {"pde-7", sheng + "Figure 7", "The application", drawWindow, moved},
    {"pde-8", sheng + "Figure 8", "Six expressions", drawExpressions, atRest, 60, {"--resolution"}, 1},
    {"pde-9",
     sheng + "Figure 9",
     "Frames of an animation",
     drawAnimation,
     moved,
     85,
     {"--resolution", "--frame", "--index", "--time"},
     mostTextures,
     true},
    {"pde-10",
     sheng + "Figure 10",
     "Frames of another animation",
     drawTexturedAnimation,
     moved,
     85,
     {"--resolution", "--frame", "--index", "--time"},
     1,
     true},
    {"pde-table-1", sheng + "Table 1", "The six expressions as FAPs", drawExpressionTable, noFace},
    {"fdt-2", obaid + "Figure 2", "Points deformed", drawDeformedPoints, deformed},
    {"fdt-3", obaid + "Figure 3", "From points to twelve parameters", drawParameterFit, moved},
    {"fdt-4", obaid + "Figure 4", "The 16 regions", drawRegions, atRest},
    {"fdt-6", obaid + "Figure 6", "Pupils", drawPupils, atRest},
    {"fdt-7", obaid + "Figure 7", "Pupil normalisation", drawNormalisation, atRest},
    {"fdt-8", obaid + "Figure 8", "The published smile", drawSmile, moved, usualWidth, {"--resolution"}},
    {"fdt-table-1", obaid + "Table I", "Smile tables", drawSmileTable, noFace, 85},
    {"mien-continuity", "", "Continuity between patches", drawContinuity, animated, 80},
    {"mien-spectrum", "", "Spectral contributions", drawSpectrum, animated, usualWidth, {"--harmonics"}},
    {"mien-sweep", "", "The smoothing parameter", drawSweep, moved, 60, {"--smoothing"}},
    {"mien-size", "", "Bytes against error", drawSizes, moved, usualWidth, {"--resolution"}},
};

}  // namespace

const std::vector<CatalogueFigure>& figureCatalogue() {
  return figures;
}

FaceState heededState(const CatalogueFigure& figure, FaceState state) {
  const FaceDeformation deformation = state.deformation;
  if (!figure.heeds.motion) state = FaceMotion::neutralOf(state);
  state.deformation = figure.heeds.table ? deformation : FaceDeformation();
  return state;
}

const CatalogueFigure& catalogueFigure(const std::string& id) {
  const auto& all = figureCatalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& figure) { return figure.id == id; });
  if (found != all.end()) return *found;
  std::string known;
  for (const CatalogueFigure& figure : all) known += (known.empty() ? "" : ", ") + figure.id;
  throw ValueFailure("there is no figure '" + id + "'; the figures are " + known);
}

}  // namespace mien
