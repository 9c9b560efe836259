#include "vtkBoundaryCurveMeanFilter.h"

#include "BoundaryCurveData.h"
#include "FaceAcquisition.h"
#include "SurfaceMesh.h"
#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkBoundaryCurveMeanFilter);

namespace {

std::string readFaces(vtkInformationVector* inputs, std::vector<mien::FaceCurves>& faces) {
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i) {
    mien::FaceCurves face;
    const std::string fault = mien::readFaceCurves(vtkPolyData::GetData(inputs, i), face);
    if (!fault.empty()) return "input " + std::to_string(i) + ": " + fault;
    faces.push_back(std::move(face));
  }
  return {};
}

}  // namespace

vtkBoundaryCurveMeanFilter::vtkBoundaryCurveMeanFilter() = default;
vtkBoundaryCurveMeanFilter::~vtkBoundaryCurveMeanFilter() = default;

int vtkBoundaryCurveMeanFilter::FillInputPortInformation(int port, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

/// Whole curves, whatever piece of the mean is wanted.
int vtkBoundaryCurveMeanFilter::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                                    vtkInformationVector*) {
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
    mien::requestWhole(inputs[0]->GetInformationObject(i));
  return 1;
}

int vtkBoundaryCurveMeanFilter::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                            vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  std::vector<mien::FaceCurves> faces;
  mien::FaceCurves mean;
  std::string fault = readFaces(inputs[0], faces);
  if (fault.empty()) fault = mien::meanFace(faces, mean);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeFaceCurves(this->Symmetric ? mien::symmetrised(mean) : mean, vtkPolyData::GetData(outputs));
  return 1;
}

void vtkBoundaryCurveMeanFilter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Symmetric: " << (this->Symmetric ? "on" : "off") << "\n";
}
