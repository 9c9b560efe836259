#include "vtkCurveEditFilter.h"

#include "BoundaryCurveData.h"
#include "CurveEdit.h"
#include "FaceLayout.h"
#include "SurfaceMesh.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkCurveEditFilter);

vtkCurveEditFilter::vtkCurveEditFilter() : Edits(new std::vector<mien::CurveEdit>) {}

vtkCurveEditFilter::~vtkCurveEditFilter() = default;

void vtkCurveEditFilter::SetEdits(const std::vector<mien::CurveEdit>& edits) {
  if (edits == *this->Edits) return;
  *this->Edits = edits;
  this->Modified();
}

const std::vector<mien::CurveEdit>& vtkCurveEditFilter::GetEdits() const {
  return *this->Edits;
}

void vtkCurveEditFilter::AddEdit(const std::string& curve, double v, double dx, double dy, double dz,
                                 double widthDegrees, int spread, bool mirrored) {
  mien::CurveEdit edit;
  edit.curve = mien::FaceLayout::curveIndex(curve);
  edit.v = v;
  edit.move = {dx, dy, dz};
  edit.width = widthDegrees * M_PI / 180.0;
  edit.spread = spread;
  edit.mirrored = mirrored;
  this->Edits->push_back(edit);
  this->Modified();
}

void vtkCurveEditFilter::RemoveAllEdits() {
  this->SetEdits({});
}

int vtkCurveEditFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  mien::requestWhole(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkCurveEditFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                    vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (this->Edits->empty()) {
    output->ShallowCopy(input);
    return 1;
  }
  mien::FaceCurves face;
  std::string fault = mien::readFaceCurves(input, face);
  if (fault.empty()) fault = mien::applyEdits(*this->Edits, face);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeFaceCurves(face, output);
  return 1;
}

void vtkCurveEditFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Edits: " << this->Edits->size() << "\n";
}
