#include "vtkPDEFaceAlgorithm.h"

#include "BoundaryCurveData.h"
#include "FaceSurface.h"
#include "SurfaceMesh.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkPDEFaceAlgorithm::vtkPDEFaceAlgorithm() : Options(new mien::FaceSurfaceOptions) {
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

vtkPDEFaceAlgorithm::~vtkPDEFaceAlgorithm() = default;

template <class T>
void vtkPDEFaceAlgorithm::Change(T& property, const T& value) {
  if (property == value) return;
  property = value;
  this->Modified();
}

void vtkPDEFaceAlgorithm::CopyParameters(vtkPDEFaceAlgorithm* other) {
  if (other) this->SetParameters(*other->Options);
}

void vtkPDEFaceAlgorithm::SetParameters(const mien::FaceSurfaceOptions& options) {
  this->Change(*this->Options, options);
}

void vtkPDEFaceAlgorithm::SetScheme(const std::string& name) {
  this->Change(this->Options->scheme, name);
}

std::string vtkPDEFaceAlgorithm::GetScheme() const {
  return this->Options->scheme;
}

std::vector<std::string> vtkPDEFaceAlgorithm::GetSchemeNames() {
  std::vector<std::string> names;
  for (const mien::FaceScheme& scheme : mien::faceSchemes()) names.push_back(scheme.name);
  return names;
}

void vtkPDEFaceAlgorithm::SetSmoothing(double a) {
  for (int patch = 0; patch < mien::FaceLayout::patchCount; ++patch) this->SetSmoothing(patch, a);
}

void vtkPDEFaceAlgorithm::SetSmoothing(int patch, double a) {
  if (patch >= 0 && patch < mien::FaceLayout::patchCount)
    this->Change(this->Options->smoothing[patch], a);
  else
    vtkErrorMacro(<< "there is no patch " << patch << "; patches are 0 .. " << mien::FaceLayout::patchCount - 1);
}

double vtkPDEFaceAlgorithm::GetSmoothing(int patch) const {
  const bool exists = patch >= 0 && patch < mien::FaceLayout::patchCount;
  return exists ? this->Options->smoothing[patch] : 0.0;
}

void vtkPDEFaceAlgorithm::SetNumberOfModes(int modes) {
  this->Change(this->Options->modes, modes);
}

int vtkPDEFaceAlgorithm::GetNumberOfModes() const {
  return this->Options->modes;
}

void vtkPDEFaceAlgorithm::SetRemainder(bool on) {
  this->Change(this->Options->remainder, on);
}

bool vtkPDEFaceAlgorithm::GetRemainder() const {
  return this->Options->remainder;
}

void vtkPDEFaceAlgorithm::SetDerivativeStrength(double strength) {
  this->Change(this->Options->derivativeStrength, strength);
}

double vtkPDEFaceAlgorithm::GetDerivativeStrength() const {
  return this->Options->derivativeStrength;
}

vtkTypeBool vtkPDEFaceAlgorithm::ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                                                vtkInformationVector* outputs) {
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
    return this->RequestInformation(request, inputs, outputs);
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
    return this->RequestUpdateExtent(request, inputs, outputs);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA())) return this->RequestData(request, inputs, outputs);
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkPDEFaceAlgorithm::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkPDEFaceAlgorithm::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) {
  return 1;
}

int vtkPDEFaceAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*) {
  mien::requestWhole(inputs[0]->GetInformationObject(0));
  return 1;
}

bool vtkPDEFaceAlgorithm::ReadCurves(vtkInformationVector** inputs, mien::FaceCurves& face) {
  const std::string fault = mien::readFaceCurves(vtkPolyData::GetData(inputs[0]), face);
  if (!fault.empty()) vtkErrorMacro(<< fault);
  return fault.empty();
}

bool vtkPDEFaceAlgorithm::ReadInput(vtkInformationVector** inputs, mien::FaceCurves& face) {
  if (!this->ReadCurves(inputs, face)) return false;
  const std::string fault = mien::describeFault(*this->Options, face.curves.pointsPerCurve);
  if (!fault.empty()) vtkErrorMacro(<< fault);
  return fault.empty();
}

void vtkPDEFaceAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Options->scheme << "\n";
  os << indent << "Smoothing:";
  for (const double a : this->Options->smoothing) os << " " << a;
  os << "\n" << indent << "NumberOfModes: " << this->Options->modes << "\n";
  os << indent << "Remainder: " << this->Options->remainder << "\n";
  os << indent << "DerivativeStrength: " << this->Options->derivativeStrength << "\n";
}
