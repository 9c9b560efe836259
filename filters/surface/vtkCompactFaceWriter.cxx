#include "vtkCompactFaceWriter.h"

#include "BoundaryCurveData.h"
#include "CompactFace.h"
#include "WholeFile.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkCompactFaceWriter);

vtkCompactFaceWriter::~vtkCompactFaceWriter() {
  this->SetFileName(nullptr);
}

int vtkCompactFaceWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

std::string vtkCompactFaceWriter::Encode(std::string& bytes) {
  auto* data = vtkPolyData::SafeDownCast(this->GetInput());
  mien::FaceCurves face;
  mien::HeadRotation turned;
  std::string fault = mien::readFaceCurves(data, face);
  if (fault.empty()) fault = mien::readHeadRotation(data->GetFieldData(), turned);
  if (!fault.empty()) return fault;
  if (turned.turns())
    vtkWarningMacro("the head is turned; a compact face file holds it in its own frame, looking forward");
  turned.undo(face.curves.points);
  return mien::encodeCompactFace(face, this->FaceName, this->Tolerance, bytes);
}

void vtkCompactFaceWriter::WriteData() {
  const std::string name = this->FileName ? this->FileName : "";
  std::string bytes;
  std::string fault = this->Encode(bytes);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return;
  }
  fault = mien::WholeFile::write(name, bytes);
  if (!fault.empty()) vtkErrorMacro(<< name << ": " << fault);
}

void vtkCompactFaceWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "FaceName: " << this->FaceName << "\n";
}
