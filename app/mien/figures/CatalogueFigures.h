#pragma once

#include "FigureDrawing.h"

namespace mien {

class FigureContext;

/// The figures of the catalogue, one file each. They throw a FileFailure or a ValueFailure.
FigureDrawing drawBoundaryCurves(FigureContext& context);
FigureDrawing drawMeshes(FigureContext& context);
FigureDrawing drawTextureWarp(FigureContext& context);
FigureDrawing drawActiveArea(FigureContext& context);
FigureDrawing drawEyebrow(FigureContext& context);
FigureDrawing drawMouth(FigureContext& context);
FigureDrawing drawWindow(FigureContext& context);
FigureDrawing drawExpressions(FigureContext& context);
FigureDrawing drawAnimation(FigureContext& context);
FigureDrawing drawTexturedAnimation(FigureContext& context);
FigureDrawing drawExpressionTable(FigureContext& context);
FigureDrawing drawDeformedPoints(FigureContext& context);
FigureDrawing drawParameterFit(FigureContext& context);
FigureDrawing drawRegions(FigureContext& context);
FigureDrawing drawPupils(FigureContext& context);
FigureDrawing drawNormalisation(FigureContext& context);
FigureDrawing drawSmile(FigureContext& context);
FigureDrawing drawSmileTable(FigureContext& context);
FigureDrawing drawContinuity(FigureContext& context);
FigureDrawing drawSpectrum(FigureContext& context);
FigureDrawing drawSweep(FigureContext& context);
FigureDrawing drawSizes(FigureContext& context);

}  // namespace mien
