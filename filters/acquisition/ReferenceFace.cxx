#include "ReferenceFace.h"

#include "BoundaryCurveData.h"
#include "GenericLandmarkFile.h"
#include "LandmarkTable.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

FaceCurves readReferenceFace() {
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->Update();
  FaceCurves face;
  readFaceCurves(reader->GetOutput(), face);
  return face;
}

FaceLandmarks readReferenceLandmarks() {
  LandmarkTable table;
  parseLandmarks(GenericLandmarkFile(), table);
  return table.positions;
}

}  // namespace

const FaceCurves& referenceFace() {
  static const FaceCurves face = readReferenceFace();
  return face;
}

const FaceLandmarks& referenceLandmarks() {
  static const FaceLandmarks landmarks = readReferenceLandmarks();
  return landmarks;
}

const FaceTemplate& referenceTemplate() {
  static const FaceTemplate face = makeFaceTemplate(referenceFace(), referenceLandmarks());
  return face;
}

}  // namespace mien
