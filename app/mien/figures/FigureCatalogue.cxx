#include "FigureCatalogue.h"

#include <algorithm>

#include "CatalogueFigures.h"
#include "Failure.h"

namespace mien {

namespace {

const std::string sheng = "Sheng et al. 2011, ", obaid = "Obaid et al. 2009, ";

constexpr int mostTextures = 8;  // rows of one figure

const std::vector<CatalogueFigure> figures = {
    {"pde-1", sheng + "Figure 1", "Boundary curves of the face",
     "The 29 boundary curves, frontal half, with the mouth closed and open.", drawBoundaryCurves},
    {"pde-2", sheng + "Figure 2", "One face at two resolutions",
     "The same curves as 28 x 20 and as 50 x 40 points, as wireframe and shaded.", drawMeshes},
    {"pde-3", sheng + "Figure 3", "Texture warp", "The six steps from a photograph to a textured face.",
     drawTextureWarp, 1},
    {"pde-4", sheng + "Figure 4", "Moving one curve",
     "Curves and active area before and after, and the motion of the active area.", drawActiveArea},
    {"pde-5", sheng + "Figure 5", "The left eyebrow", "FAPs 31, 33 and 35 as staggered sinusoids on the brow's curve.",
     drawEyebrow},
    {"pde-6", sheng + "Figure 6", "The mouth", "The curves of the lips, and the ways of the inner contours.",
     drawMouth},
    {"pde-7", sheng + "Figure 7", "The application", "Mien Studio's window.", drawWindow},
    {"pde-8", sheng + "Figure 8", "Six expressions",
     "Anger, joy, sadness, disgust, fear and surprise as curves, as a mesh of 29 x 40 points and textured.",
     drawExpressions, 1},
    {"pde-9", sheng + "Figure 9", "Frames of an animation",
     "Five frames as curves, motion vector fields and textured faces.", drawAnimation, mostTextures, true},
    {"pde-10", sheng + "Figure 10", "Frames of another animation", "Five textured frames.", drawTexturedAnimation, 1,
     true},
    {"pde-table-1", sheng + "Table 1", "The six expressions as FAPs",
     "Definition, facial actions, and the FAPs with their values.", drawExpressionTable},
    {"fdt-2", obaid + "Figure 2", "Points deformed", "A set of points before and after a deformation table.",
     drawDeformedPoints},
    {"fdt-3", obaid + "Figure 3", "From points to twelve parameters",
     "Points of one region before and after, and the quadratic map fitted to them.", drawParameterFit},
    {"fdt-4", obaid + "Figure 4", "The 16 regions", "The regions on the face, with their names.", drawRegions},
    {"fdt-6", obaid + "Figure 6", "Pupils", "A face as recorded and in pupil units.", drawPupils},
    {"fdt-7", obaid + "Figure 7", "Pupil normalisation", "Moved, turned and scaled, step by step.", drawNormalisation},
    {"fdt-8", obaid + "Figure 8", "The published smile", "The neutral face, and Table I applied to it.", drawSmile},
    {"fdt-table-1", obaid + "Table I", "Smile tables",
     "The published table beside Mien's own mean with standard deviations.", drawSmileTable},
    {"mien-continuity", "", "Continuity between patches", "The angle along every seam, in every scheme.",
     drawContinuity},
    {"mien-spectrum", "", "Spectral contributions", "What each mode adds, and what partial sums lack.", drawSpectrum},
    {"mien-sweep", "", "The smoothing parameter", "Surface and measures over a, in every scheme.", drawSweep},
    {"mien-size", "", "Bytes against error", "Modes, quantised modes and decimated meshes.", drawSizes},
};

}  // namespace

const std::vector<CatalogueFigure>& figureCatalogue() {
  return figures;
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
